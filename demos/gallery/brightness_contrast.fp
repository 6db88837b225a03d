!!ARBfp1.0
#@ title "Brightness and contrast", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
#@ local[0].x "gamma" = 0.8 in 0.2..3
#@ local[0].y "contrast" = 1.3 in 0..3, local[0].z "brightness" = -0.1 in -1..1
# A power bends the middle tones; contrast stretches about black, brightness shifts.
PARAM level = program.local[0];
TEMP colour;
TEX colour, fragment.texcoord[0], texture[0], 2D;
POW colour.x, colour.x, level.x;
POW colour.y, colour.y, level.x;
POW colour.z, colour.z, level.x;
MAD_SAT result.color, colour, level.y, level.z;
END
