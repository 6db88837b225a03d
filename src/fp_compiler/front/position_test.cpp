// Tests programs with one planted error each. GL_PROGRAM_ERROR_POSITION_ARB must be the first wrong
// byte, whatever newlines and comments come before it (3.11.2).
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/planted.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::firstError;
using testing_support::Planted;

constexpr Planted kPlanted[] = {
    {"syntax", "MOV R0 @R1;\nEND"},
    {"syntax", "MOV R0, R1@\nMOV R1, R0;\nEND"},
    {"syntax", "MOV R0, R1@\nEND"},
    {"syntax", "MOV R0,@;\nEND"},
    {"syntax", "MOV @, R0;\nEND"},
    {"syntax", "@;\nEND"},
    {"syntax", "MOV R0, R1;@;\nEND"},
    {"syntax", "ADD R0, R1@;\nEND"},
    {"syntax", "ADD R0, R1, R1@, R1;\nEND"},
    {"syntax", "MAD R0, R1, R0@;\nEND"},
    {"syntax", "KIL R0@, R1;\nEND"},
    {"syntax", "MOV R0, -@-R1;\nEND"},
    {"syntax", "MOV R0, R1.@;\nEND"},
    {"syntax", "MOV R0, R1@..x;\nEND"},
    {"syntax", "MOV R0, 2.@x;\nEND"},
    {"syntax", "MOV R0, {1, 2, 3, 4@, 5};\nEND"},
    {"syntax", "MOV R0, {@};\nEND"},
    {"syntax", "MOV R0, {1,@};\nEND"},
    {"syntax", "MOV R0, {1 @2};\nEND"},
    {"syntax", "MOV R0, {1@;\nEND"},
    {"syntax", "TEMP a @b;\nEND"},
    {"syntax", "TEMP a,@;\nEND"},
    {"syntax", "TEMP @7;\nEND"},
    {"syntax", "TEMP a@\nTEMP b;\nEND"},
    {"syntax", "PARAM p @{1, 2};\nEND"},
    {"syntax", "PARAM p = @;\nEND"},
    {"syntax", "PARAM p = program.local[0@..3];\nEND"},
    {"syntax", "PARAM p = state.matrix.mvp@;\nEND"},
    {"syntax", "PARAM p = state.matrix.mvp.row[0@..1];\nEND"},
    {"syntax", "PARAM p[] = @3;\nEND"},
    {"syntax", "PARAM p[] = {@};\nEND"},
    {"syntax", "PARAM p[@-1] = {3};\nEND"},
    {"syntax", "PARAM p[@2.5] = {3};\nEND"},
    {"syntax", "PARAM p = program.env[@1.0];\nEND"},
    {"syntax", "PARAM p = program.env[1@;\nEND"},
    {"syntax", "PARAM p = program.env@;\nEND"},
    {"syntax", "PARAM p = program.env[@-1];\nEND"},
    {"syntax", "ATTRIB a = @color;\nEND"},
    {"syntax", "ATTRIB a @fragment.color;\nEND"},
    {"syntax", "OUTPUT o = @R0;\nEND"},
    {"syntax", "OUTPUT o = result.depth@.z;\nEND"},
    {"syntax", "ALIAS a = @3;\nEND"},
    {"syntax", "TEX R0, R1, @R2, 2D;\nEND"},
    {"syntax", "TEX R0, R1, texture[0]@;\nEND"},
    {"syntax", "TEX R0, R1, texture[0@, 2D;\nEND"},
    {"syntax", "TEX R0, R1, texture @2D;\nEND"},
    {"unknown-target", "TEX R0, R1, texture[0], @2Dx;\nEND"},
    {"syntax", "SWZ R0, R1, x, y, z@;\nEND"},
    {"syntax", "SWZ R0, R1, x, y, z, w@, w;\nEND"},
    {"syntax", "SWZ R0, R1, x, y, @., w;\nEND"},
    {"syntax", "OPTION @;\nEND"},
    {"syntax", "@fragment.color;\nEND"},
    {"syntax", "@2.0;\nEND"},
    {"invalid-character", "MOV R0, @|R1|;\nEND"},
    {"invalid-character", "MOV R0, R1;@\v\nEND"},
    {"invalid-character", "MOV R0@/* c */, R1;\nEND"},
    {"invalid-character", "@\xC3\xA4;\nEND"},
    {"end-missing", "MOV R0, R1;\n@"},
    {"end-missing", "MOV R0, R1; # END@"},
    {"text-after-end", "END\n@END"},
    {"text-after-end", "END@;"},
    {"text-after-end", "END # done\n@\xEF"},
    {"unknown-instruction", "@mov R0, R1;\nEND"},
    {"unknown-instruction", "@KIL_SAT R0;\nEND"},
    {"unknown-instruction", "@MOV_sat R0, R1;\nEND"},
    {"unknown-instruction", "@end"},
    {"unknown-binding", "MOV R0, fragment.@colour;\nEND"},
    {"unknown-binding", "ATTRIB a = fragment.color.@third;\nEND"},
    {"unknown-binding", "MOV result.@colour, R0;\nEND"},
    {"unknown-binding", "PARAM p = state.@materiel.ambient;\nEND"},
    {"unknown-binding", "PARAM p = state.material.@shiny;\nEND"},
    {"unknown-binding", "PARAM p = state.material.back.@front;\nEND"},
    {"unknown-binding", "PARAM p = state.light[0].@colour;\nEND"},
    {"unknown-binding", "PARAM p = state.light[0].spot.@cutoff;\nEND"},
    {"unknown-binding", "PARAM p = state.lightmodel.@emission;\nEND"},
    {"unknown-binding", "PARAM p = state.lightmodel.front.@ambient;\nEND"},
    {"unknown-binding", "PARAM p = state.lightprod[0].@emission;\nEND"},
    {"unknown-binding", "PARAM p = state.texenv[0].@colour;\nEND"},
    {"unknown-binding", "PARAM p = state.fog.@density;\nEND"},
    {"unknown-binding", "PARAM p = state.depth.@near;\nEND"},
    {"unknown-binding", "PARAM p = state.matrix.@mpv.row[0];\nEND"},
    {"unknown-binding", "PARAM p = state.matrix.mvp.@inverted.row[0];\nEND"},
    {"unknown-binding", "PARAM p = state.matrix.mvp.inverse.@transpose.row[0];\nEND"},
    {"unknown-binding", "PARAM p = program.@global[0];\nEND"},
    {"vertex-only", "MOV R0, @vertex.position;\nEND"},
    {"vertex-only", "ATTRIB a = @vertex.position;\nEND"},
    {"vertex-only", "@ADDRESS A0;\nEND"},
    {"vertex-only", "@ARL R0.x, R1.x;\nEND"},
    {"vertex-only", "@EXP R0, R1.x;\nEND"},
    {"vertex-only", "MOV result.@position, R0;\nEND"},
    {"vertex-only", "MOV result.color.@secondary, R0;\nEND"},
    {"vertex-only", "PARAM p = state.@clip[0].plane;\nEND"},
    {"nv-only", "@DDX R0, R1;\nEND"},
    {"nv-only", "@ADDR R0, R1, R1;\nEND"},
    {"nv-only", "@MULH_SAT R0, R1, R1;\nEND"},
    {"nv-only", "@SHORT TEMP R9;\nEND"},
    {"late-option", "MOV R0, R1;\n@OPTION ARB_fog_exp;\nEND"},
    {"reserved-name", "TEMP @MOV;\nEND"},
    {"reserved-name", "TEMP a, @texture, b;\nEND"},
    {"reserved-name", "PARAM @END = 1;\nEND"},
    {"reserved-name", "ALIAS @state = R0;\nEND"},
    {"reserved-name", "ATTRIB @ADD_SAT = fragment.color;\nEND"},
    {"redeclared-name", "TEMP a;\nTEMP b, @a;\nEND"},
    {"redeclared-name", "PARAM a = 1;\nATTRIB @a = fragment.color;\nEND"},
    {"redeclared-name", "PARAM a = 1;\nPARAM @a[2] = {1, 2};\nEND"},
    {"redeclared-name", "ALIAS a = R0;\nOUTPUT @a = result.color;\nEND"},
    {"redeclared-name", "ALIAS @R0 = R1;\nEND"},
    {"undeclared-name", "MOV R0, @R9;\nEND"},
    {"undeclared-name", "MOV @r0, R0;\nEND"},
    {"undeclared-name", "ADD R0, R1, -@foo[3].x;\nEND"},
    {"undeclared-name", "MOV R0, @later;\nTEMP later;\nEND"},
    {"undeclared-name", "KIL @gone;\nEND"},
    {"bad-alias", "ALIAS a = @b;\nEND"},
    {"bad-alias", "ALIAS a = @a;\nEND"},
    {"bad-alias", "ALIAS a = @fragment.color;\nEND"},
    {"read-only-destination", "MOV @fragment.color, R0;\nEND"},
    {"read-only-destination", "MOV @program.local[0], R0;\nEND"},
    {"read-only-destination", "MOV @state.fog.color, R0;\nEND"},
    {"read-only-destination", "ATTRIB a = fragment.color;\nMOV @a.x, R0;\nEND"},
    {"read-only-destination", "PARAM p = 1;\nMOV @p, R0;\nEND"},
    {"read-only-destination", "PARAM p[] = {1, 2};\nMOV @p[1].x, R0;\nEND"},
    {"read-only-destination", "MOV @{1, 2}, R0;\nEND"},
    {"write-only-source", "MOV R0, @result.color;\nEND"},
    {"write-only-source", "OUTPUT o = result.color;\nADD R0, R1, -@o.x;\nEND"},
    {"parameter-index", "PARAM p = program.env[@32];\nEND"},
    {"parameter-index", "MOV R0, program.local[@32];\nEND"},
    {"parameter-index", "PARAM p[] = {program.local[0..@99]};\nEND"},
    {"parameter-index", "PARAM p = program.env[@2147483648];\nEND"},
    {"parameter-index", "PARAM p = program.env[@4294967296];\nEND"},
    {"parameter-index", "PARAM p = program.env[@18446744073709551616];\nEND"},
    {"reversed-range", "PARAM p[] = {program.env[5..@3]};\nEND"},
    {"reversed-range", "PARAM p[] = {state.matrix.mvp.row[2..@1]};\nEND"},
    {"matrix-row", "PARAM p = state.matrix.mvp.row[@4];\nEND"},
    {"matrix-row", "PARAM p[] = {state.matrix.mvp.row[0..@4]};\nEND"},
    {"matrix-index", "PARAM p = state.matrix.modelview[@1].row[0];\nEND"},
    {"matrix-index", "PARAM p = state.matrix.texture[@8].row[0];\nEND"},
    {"matrix-index", "PARAM p = state.matrix.palette[@0].row[0];\nEND"},
    {"matrix-index", "PARAM p[] = {state.matrix.program[@8]};\nEND"},
    {"array-size", "PARAM p[@0] = {1};\nEND"},
    {"array-size", "PARAM p[@33] = {1};\nEND"},
    {"array-size-mismatch", "PARAM p[3] = {1, 2@};\nEND"},
    {"array-size-mismatch", "PARAM p[2] = {1, 2, @3, 4};\nEND"},
    {"array-size-mismatch", "PARAM p[3] = {1, @state.matrix.mvp, 4};\nEND"},
    {"array-index", "PARAM p[] = {1, 2};\nMOV R0, p[@2];\nEND"},
    {"array-index", "PARAM p[] = {1, 2};\nALIAS q = p;\nMOV R0, q[@4294967296];\nEND"},
    {"array-not-indexed", "PARAM p[] = {1, 2};\nMOV R0, p@;\nEND"},
    {"array-not-indexed", "PARAM p[] = {1, 2};\nADD R0, p@.x, R1;\nEND"},
    {"not-an-array", "MOV R0, R1@[0];\nEND"},
    {"not-an-array", "PARAM p = 1;\nMOV R0, p@[0];\nEND"},
    {"not-an-array", "MOV R0@[0], R1;\nEND"},
    {"relative-addressing", "PARAM p[] = {1, 2};\nMOV R0, p[@R1.x];\nEND"},
    {"texcoord-index", "MOV R0, fragment.texcoord[@8];\nEND"},
    {"texcoord-index", "ATTRIB a = fragment.texcoord[@99999999999];\nEND"},
    {"texenv-index", "PARAM p = state.texenv[@8].color;\nEND"},
    {"light-index", "PARAM p = state.light[@8].diffuse;\nEND"},
    {"light-index", "PARAM p = state.lightprod[@8].diffuse;\nEND"},
    {"image-unit", "TEX R0, R1, texture[@16], 2D;\nEND"},
    {"bad-swizzle", "MOV R0, R1.xyz@q;\nEND"},
    {"bad-swizzle", "MOV R0, R1.@xyz;\nEND"},
    {"bad-swizzle", "MOV R0, R1.@xy;\nEND"},
    {"bad-swizzle", "MOV R0, R1.xyzw@x;\nEND"},
    {"bad-swizzle", "MOV R0, R1.xy@ba;\nEND"},
    {"bad-swizzle", "MOV R0, fragment.color.@third;\nEND"},
    {"bad-swizzle", "MOV R0, R1.@X;\nEND"},
    {"scalar-suffix", "RCP R0, R1@;\nEND"},
    {"scalar-suffix", "COS R0, 3.14159@;\nEND"},
    {"scalar-suffix", "POW R0, R1.x, R1@;\nEND"},
    {"scalar-suffix", "RSQ R0, R1.x@y;\nEND"},
    {"scalar-suffix", "LG2 R0, R1.@q;\nEND"},
    {"bad-mask", "MOV R0.y@x, R1;\nEND"},
    {"bad-mask", "MOV R0.x@x, R1;\nEND"},
    {"bad-mask", "MOV R0.x@g, R1;\nEND"},
    {"bad-mask", "MOV R0.xyzw@x, R1;\nEND"},
    {"bad-mask", "MOV result.color.rg@z, R1;\nEND"},
    {"bad-mask", "MOV R0.@foo, R1;\nEND"},
    {"swz-operand", "SWZ R0, @-R1, x, y, z, w;\nEND"},
    {"swz-operand", "SWZ R0, R1@.xyzw, x, y, z, w;\nEND"},
    {"swz-selector", "SWZ R0, R1, x, y, @2, w;\nEND"},
    {"swz-selector", "SWZ R0, R1, x, y, z, -@a;\nEND"},
    {"swz-selector", "SWZ R0, R1, x@cellent, y, z, w;\nEND"},
    {"unknown-target", "TEX R0, R1, texture[0], @CUBEMAP;\nEND"},
    {"unknown-target", "TEX R0, R1, texture[0], @2d;\nEND"},
    {"shadow-target", "TEX R0, R1, texture[0], @SHADOW2D;\nEND"},
    {"target-conflict", "TEX R0, R1, texture[0], 2D;\nTEX R1, R0, texture, @3D;\nEND"},
    {"color-option", "MOV result.color@[0], R0;\nEND"},
    {"color-option", "OUTPUT o = result.color@[1];\nEND"},
};

TEST(ErrorPosition, IsTheFirstWrongByte) {
  EXPECT_GE(testing_support::expectPlanted("!!ARBfp1.0", kPlanted), 200);
}

struct PlantedHeader {
  const char *id;
  const char *text;
};

// Options come before all statements, so these programs have their own beginning.
constexpr PlantedHeader kHeaders[] = {
    {"header-missing", "@"},
    {"header-missing", "@ !!ARBfp1.0\nEND"},
    {"header-missing", "@# c\n!!ARBfp1.0\nEND"},
    {"header-missing", "@\xEF\xBB\xBF!!ARBfp1.0\nEND"},
    {"header-missing", "!!ARB@vp1.0\nEND"},
    {"header-missing", "!!ARBfp1.@1\nEND"},
    {"header-missing", "!!ARBfp1.@"},
    {"header-missing", "@END"},
    {"header-missing", "!!@FP1.0\nEND"},
    {"syntax", "!!ARBfp1.0@1\nEND"},
    {"unsupported-option", "!!ARBfp1.0\nOPTION @ARB_fog_cubic;\nEND"},
    {"unsupported-option", "!!ARBfp1.0 OPTION ARB_fog_exp; OPTION @NV_fragment_program; END"},
    {"unsupported-option", "!!ARBfp1.0\r\n# c\r\nOPTION @ARB_position_invariant;\r\nEND"},
    {"conflicting-fog-options", "!!ARBfp1.0\nOPTION ARB_fog_exp;\nOPTION @ARB_fog_exp2;\nEND"},
    {"conflicting-precision-hints",
     "!!ARBfp1.0\nOPTION ARB_precision_hint_nicest;\nOPTION @ARB_precision_hint_fastest;\nEND"},
    {"color-index", "!!ARBfp1.0\nOPTION ARB_draw_buffers;\nMOV result.color[@4], 1;\nEND"},
    {"target-conflict", "!!ARBfp1.0\nOPTION ARB_fragment_program_shadow;\nTEMP t;\n"
                        "TEX t, t, texture[0], 2D;\nTEX t, t, texture[0], @SHADOW2D;\nEND"},
};

TEST(ErrorPosition, IsTheFirstWrongByteOfHeaderAndOptions) {
  for (const PlantedHeader &planted : kHeaders) {
    std::string text = planted.text;
    const std::size_t marker = text.find('@');
    text.erase(marker, 1);
    const CheckResult result = checkFragmentProgram(text, testing_support::small());
    EXPECT_EQ(firstError(result), planted.id) << planted.text;
    EXPECT_EQ(result.errorPosition(), std::int32_t(marker)) << planted.text;
  }
}

TEST(ErrorPosition, IsTheFirstOfSeveralErrors) {
  const std::string text = "!!ARBfp1.0\nMOV a, b;\nMOV c.yx, d\nEND\n";
  const CheckResult result = check(text);
  EXPECT_EQ(result.errorPosition(), 15);
  // The errors are a, b, c, the mask, d, and the semicolon, in text order.
  ASSERT_EQ(result.diagnostics.size(), 6u);
  for (std::size_t i = 1; i < result.diagnostics.size(); ++i)
    EXPECT_LE(result.diagnostics[i - 1].span.begin, result.diagnostics[i].span.begin);
}

TEST(ErrorPosition, OfAProgramThatLoadsIsMinusOne) {
  const CheckResult result = check("!!ARBfp1.0 END");
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.errorPosition(), -1);
  EXPECT_EQ(result.errorString("!!ARBfp1.0 END"), "");
}

} // namespace
} // namespace arbiter::fp
