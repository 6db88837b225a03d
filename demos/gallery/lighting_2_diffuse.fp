!!ARBfp1.0
#@ title "Lighting 2: diffuse", size 512 512
#@ mesh torus, camera orbit pitch 35 distance 2.8, vertex tangent.vp
#@ texcoord 1 = tangent, texcoord 2 = binormal
# The angle between the surface and the light, with no texture yet.
PARAM ambient = { 0.1, 0.1, 0.12, 1.0 };
TEMP toLight;
DP3 toLight.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ toLight.w, toLight.w;
MUL_SAT toLight.z, fragment.texcoord[1].z, toLight.w;
ADD result.color.xyz, ambient, toLight.z;
MOV result.color.w, ambient.w;
END
