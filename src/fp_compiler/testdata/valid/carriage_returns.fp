!!ARBfp1.0
# lines as editors of another system end them
TEMP half;
MOV half, { 0.5 };
MOV result.color.rgb, half.r;
END
