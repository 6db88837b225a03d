!!ARBfp1.0
#@ title "Pass-through", size 512 512
#@ texture 0 = landscape 512 512, linear, edge
# The picture, as it is: one sample, no arithmetic.
TEX result.color, fragment.texcoord[0], texture[0], 2D;
END
