!!ARBfp1.0
OPTION ARB_fog_exp2;
OPTION ARB_precision_hint_nicest;
OPTION ARB_fragment_program_shadow;
OPTION ATI_draw_buffers;
OPTION ARB_fragment_coord_origin_upper_left;
OPTION ARB_fragment_coord_pixel_center_integer;
OUTPUT first = result.color;
OUTPUT second = result.color[1];
TEMP lit;
TXP lit, fragment.texcoord[0], texture[0], SHADOW2D;
MUL first, lit.x, fragment.color;
MOV second, fragment.position;
END
