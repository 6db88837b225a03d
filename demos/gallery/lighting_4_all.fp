!!ARBfp1.0
#@ title "Lighting 4: bricks, bumps, highlights", size 512 512
#@ mesh torus, camera orbit pitch 35 distance 2.8, vertex tangent.vp
#@ texcoord 1 = tangent, texcoord 2 = binormal
#@ texture 0 = normals strength 3 of bricks 256 256 rows 16 columns 16 gray 1, linear
#@ texture 1 = bricks 256 256 rows 16 columns 16, linear
#@ local[0].x "shininess" = 24 in 1..100, local[0].y "gloss" = 0.6 in 0..1
# All of it: the colour is a texture too, and LIT makes diffuse and specular of two angles.
PARAM gloss = program.local[0];
PARAM unpack = { 2.0, -1.0, 0.15, 1.0 };
TEMP normal, surface, toLight, halfway, shade;
TEX normal, fragment.texcoord[0], texture[0], 2D;
TEX surface, fragment.texcoord[0], texture[1], 2D;
MAD normal.xyz, normal, unpack.x, unpack.y;
DP3 normal.w, normal, normal;
RSQ normal.w, normal.w;
MUL normal.xyz, normal, normal.w;
DP3 toLight.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ toLight.w, toLight.w;
MUL toLight.xyz, fragment.texcoord[1], toLight.w;
DP3 halfway.w, fragment.texcoord[2], fragment.texcoord[2];
RSQ halfway.w, halfway.w;
MAD halfway.xyz, fragment.texcoord[2], halfway.w, toLight;
DP3 halfway.w, halfway, halfway;
RSQ halfway.w, halfway.w;
MUL halfway.xyz, halfway, halfway.w;
DP3 shade.x, normal, toLight;
DP3 shade.y, normal, halfway;
MOV shade.w, gloss.x;
LIT shade, shade;
ADD shade.y, shade.y, unpack.z;
MUL shade.z, shade.z, gloss.y;
MAD_SAT result.color.xyz, surface, shade.y, shade.z;
MOV result.color.w, unpack.w;
END
