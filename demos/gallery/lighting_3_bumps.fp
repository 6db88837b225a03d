!!ARBfp1.0
#@ title "Lighting 3: bumps", size 512 512
#@ mesh torus, camera orbit pitch 35 distance 2.8, vertex tangent.vp
#@ texcoord 1 = tangent, texcoord 2 = binormal
#@ texture 0 = normals strength 3 of bumps 256 256 count 8, linear
# The surface's normal is now the texture's.
PARAM unpack = { 2.0, -1.0, 0.1, 1.0 };
TEMP normal, toLight;
TEX normal, fragment.texcoord[0], texture[0], 2D;
MAD normal.xyz, normal, unpack.x, unpack.y;
DP3 normal.w, normal, normal;
RSQ normal.w, normal.w;
MUL normal.xyz, normal, normal.w;
DP3 toLight.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ toLight.w, toLight.w;
MUL toLight.xyz, fragment.texcoord[1], toLight.w;
DP3_SAT toLight.x, normal, toLight;
ADD result.color.xyz, toLight.x, unpack.z;
MOV result.color.w, unpack.w;
END
