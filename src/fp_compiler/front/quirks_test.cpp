// Tests quirks of real applications' programs that a stricter parser might refuse.
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::wrap;

void loads(const std::string &text) {
  const CheckResult result = check(text);
  EXPECT_TRUE(result.ok()) << text << "\n" << result.errorString(text);
  EXPECT_TRUE(result.diagnostics.empty());
}

TEST(Quirks, GlslReservedWordsAsNames) {
  loads(wrap("TEMP out, output, half, input, default, const, float, vec4, main, void, sampler2D;\n"
             "MOV out, 1;\nMOV result.color, out;"));
}

TEST(Quirks, GlslBuiltInsAndPrefixesAsNames) {
  loads(wrap("TEMP reflect, exp, step, gl_FragColor, __tmp_texcoord0, texture2D;\n"
             "PARAM mix = 1;\nMOV __tmp_texcoord0, mix;\nMOV reflect, gl_FragColor;"));
}

TEST(Quirks, WordsOfTheLanguageThatAreNotReserved) {
  loads(wrap("TEMP color, texcoord, position, row, matrix, env, local, x, y, rgba, RECT, CUBE;\n"
             "MOV x.x, y.y;\nMOV color, fragment.color;\nSWZ rgba, x, x, y, 0, w;"));
}

TEST(Quirks, NothingBetweenHeaderAndStatement) { loads("!!ARBfp1.0MOV result.color,1;END"); }

TEST(Quirks, AWholeProgramOnOneLine) {
  loads("!!ARBfp1.0 TEMP c; TEX c, fragment.texcoord[0], texture[0], 2D; MUL result.color, c, "
        "fragment.color; END");
}

TEST(Quirks, DeclarationsAfterInstructions) {
  loads(wrap("TEMP a;\nMOV a, fragment.color;\nTEMP b;\nPARAM p = {1,2,3,4};\n"
             "MUL b, a, p;\nOUTPUT o = result.color;\nMOV o, b;"));
}

TEST(Quirks, ShortVectors) {
  loads(wrap("TEMP t;\nADD t, {0.25,0.25,0.25}, {0.859375};\nMOV result.color, t;"));
}

TEST(Quirks, ColorLettersEverywhere) {
  loads(wrap("TEMP t;\nMOV t.rgb, fragment.color.bgra;\nMOV t.a, t.r;\nRCP t.g, t.b;"));
}

TEST(Quirks, TextureWithoutAnIndex) {
  loads(wrap("TEX result.color, fragment.texcoord, texture, 2D;"));
}

TEST(Quirks, RangesInArrays) {
  loads(wrap("PARAM c[12] = { program.local[0..11] };\nMOV result.color, c[11];"));
}

TEST(Quirks, CarriageReturns) {
  loads("!!ARBfp1.0\r\n# comment\r\nTEMP t;\r\nMOV t, 1;\r\nMOV result.color, t;\r\nEND\r\n");
}

TEST(Quirks, AnyBytesInComments) {
  loads("!!ARBfp1.0 # \xA9 1999 \xC3\xA4\x01\x7F\nMOV result.color, 1;END#\xFF");
}

TEST(Quirks, AlphaNeverWritten) { loads(wrap("MOV result.color.xyz, fragment.color;")); }

TEST(Quirks, NothingWritten) { loads("!!ARBfp1.0\nEND"); }

TEST(Quirks, WhitespaceBetweenAnyTokens) {
  loads("!!ARBfp1.0\n\n\t PARAM p [ 2 ] = { program . env [ 0 .. 1 ] } ;\nTEMP t ;\n"
        "MAD t . x , - p [ 1 ] . y , fragment . texcoord [ 1 ] . x , state . matrix . mvp . row "
        "[ 0 ] . w ; TEX t , t , texture [ 1 ] , 2D ; END");
}

TEST(Quirks, AByteOfTerminatorInTheLength) {
  const std::string text("!!ARBfp1.0 END\n\0", 16);
  const CheckResult result = check(text);
  EXPECT_TRUE(result.ok());
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_STREQ(result.diagnostics[0].id, "trailing_nul");
  EXPECT_EQ(result.diagnostics[0].severity, Severity::Warning);
}

} // namespace
} // namespace arbiter::fp
