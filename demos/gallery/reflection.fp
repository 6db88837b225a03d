!!ARBfp1.0
#@ title "Reflection in a cube map", size 512 512, clear 0.3 0.35 0.4 1
#@ mesh knot, camera orbit yaw 30 pitch 20 distance 3, vertex surface.vp
#@ texture 0 = sky 64, linear
#@ local[0] = eye
#@ local[1].x "tint" = 0.85 in 0..1
# Where the eye's ray goes from the surface: r = 2 n (n e) - e (n n).
PARAM eye = program.local[0];
PARAM tint = program.local[1];
PARAM two = { 2.0, 0.0, 0.0, 1.0 };
TEMP toEye, normal, ray;
SUB toEye.xyz, eye, fragment.texcoord[2];
DP3 normal.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[1], normal.w;
DP3 ray.w, normal, toEye;
MUL ray.w, ray.w, two.x;
MAD ray.xyz, normal, ray.w, -toEye;
TEX ray, ray, texture[0], CUBE;
MUL result.color.xyz, ray, tint.x;
MOV result.color.w, two.w;
END
