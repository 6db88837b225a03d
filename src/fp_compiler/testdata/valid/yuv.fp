!!ARBfp1.0
TEMP yuv, rgb;
TEX yuv.r, fragment.texcoord[0], texture[0], 2D;
TEX yuv.g, fragment.texcoord[1], texture[1], 2D;
TEX yuv.b, fragment.texcoord[1], texture[2], 2D;
SUB yuv, yuv, { 0.0625, 0.5, 0.5, 0 };
DP3 rgb.r, yuv, { 1.164, 0, 1.596, 0 };
DP3 rgb.g, yuv, { 1.164, -0.391, -0.813, 0 };
DP3 rgb.b, yuv, { 1.164, 2.018, 0, 0 };
MOV rgb.a, 1.0;
MOV_SAT result.color, rgb;
END
