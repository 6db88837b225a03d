!!ARBfp1.0
OPTION ARB_draw_buffers;
MOV result.color[4], 1;
END
