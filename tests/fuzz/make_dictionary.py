"""Writes a libFuzzer dictionary of the program languages: opcodes from the opcode table, and other words of
programs."""

import re
import sys

WORDS = """
!!ARBfp1.0 END OPTION TEMP PARAM ATTRIB OUTPUT ALIAS ADDRESS
ARB_fog_exp ARB_fog_exp2 ARB_fog_linear ARB_precision_hint_fastest ARB_precision_hint_nicest
ARB_fragment_program_shadow ARB_draw_buffers ATI_draw_buffers NV_fragment_program
ARB_fragment_coord_origin_upper_left ARB_fragment_coord_pixel_center_integer
fragment. color primary secondary texcoord fogcoord position
result.color result.depth texture 1D 2D 3D CUBE RECT SHADOW1D SHADOW2D SHADOWRECT
program.env program.local state. material. front. back. ambient diffuse specular emission shininess
light[ attenuation spot.direction half lightmodel. scenecolor lightprod[ texenv fog. params
depth.range matrix. modelview projection mvp palette[ program[ inverse transpose invtrans
.row[ .. [0] [0..3] [] , ; = { } + - .xyzw .rgba .x .a .wzyx .xyz _SAT
0 1 2.5 .5 5. 1e3 1e999 4294967296 65536
!!ARBvp1.0 ARB_position_invariant NV_vertex_program2 vertex. normal weight matrixindex[ attrib[
result.position result.fogcoord result.pointsize result.texcoord[ .front .back .secondary
texgen .eye.s .object.q clip[ .plane point.size A0 [A0.x] [A0.x+63] [A0.x-64]
!!ATIfs1.0 StartConstants; EndConstants; StartPrelimPass; StartOutputPass; EndPass; CONSTANT
PassTexCoord SampleMap DOT3 DOT4 DOT2ADD LERP CND CND0 r0 r5 c0 c7 t0 t5 color0 color1
NV_fragment_program2 NV_vertex_program3 SHORT LONG ADDC ADDR MULH_SAT MOVC1 _SSAT (EQ) (NE.x) (GT.wzyx)
(LT1.y) |a| -|a.x| lab: facing IF IF(TR) [A0.w+3]
!!FP1.0 !!VP1.0 !!VP1.1 !!VP2.0 !!VSP1.0 DEFINE DECLARE NV_position_invariant f[WPOS] f[FOGC] f[TEX0]
o[COLR] o[COLH] o[DEPR] o[HPOS] o[TEX7] o[BFC0] p[1] v[0] v[OPOS] v[WGHT] c[0] c[95] c[A0.x+63] c[A1.y-256]
R0 R11 H63 RC HC CC A0.x A1 TEX15
!!RC1.0 !!TS1.0 rgb alpha out.rgb out.a spare0 spare1 tex0 tex3 const0 const1 fog zero one discard
color_sum final_product unsigned( unsigned_invert( expand( half_bias( sum(); mux(); lerp(
scale_by_two(); scale_by_four(); scale_by_one_half(); bias_by_negative_one_half(); clamp_color_sum();
per_stage_constants(); bias_by_negative_one_half_scale_by_two(); ( ) * // /* */
nop(); texture_1d(); texture_2d(); texture_3d(); texture_rectangle(); texture_cube_map(); pass_through();
cull_fragment( GEQUAL_TO_ZERO LESS_THAN_ZERO offset_2d( offset_2d_scale( dependent_ar( dependent_gb(
dot_product_2d_1of2( dot_product_2d_2of2( dot_product_3d_1of3( dot_product_3d_2of3( dot_product_3d_3of3(
dot_product_reflect_cube_map_const_eye_ 1of3( 2of3( 3of3( force_blue_to_one( dependent_rgb_3d(
.str .stq .str_dr .stq_dq .2x .4x .8x .half .quarter .eighth .sat .neg .bias .comp .rgb
"""


def main(ops_path, out_path):
    with open(ops_path, encoding="utf-8") as ops:
        opcodes = re.findall(r'^FP_(?:NV_)?(?:OP|WORD)\(\w+,\s*"(\w+)"', ops.read(), re.MULTILINE)
    if len(opcodes) < 30:
        sys.exit(f"{ops_path}: only {len(opcodes)} opcodes found")
    words = WORDS.split() + [f"{opcode} " for opcode in opcodes]
    with open(out_path, "w", encoding="utf-8") as out:
        for word in words:
            out.write(f'"{word}"\n')
        out.write('"\\x0d\\x0a"\n"#"\n"\\x00"\n')


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
