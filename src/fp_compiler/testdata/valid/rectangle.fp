!!ARBfp1.0
# Sums of a rectangle texture and its neighbour.
TEMP out, output;
TXP out, fragment.texcoord[0], texture[0], RECT;
ADD output, fragment.texcoord[0], { 1, 0, 0, 0 };
TXP output, output, texture[0], RECT;
LRP result.color, { 0.25, 0.25, 0.25 }, out, output;
END
