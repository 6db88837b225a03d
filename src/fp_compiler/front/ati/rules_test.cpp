#include <algorithm>
#include <gtest/gtest.h>

#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/testing/eight_units.h"

// Tests every rule of ATI_text_fragment_shader 3.10.1 and every part of its grammar, both accepted
// and refused. A case is an !!ATIfs1.0 text with '@' before the byte that the first error must
// name.
namespace arbiter::fp::ati {
namespace {

CheckResult check(const std::string &text, const CompileOptions &options = eightUnits()) {
  return checkProgram(ir::Language::AtiFragment, text, options);
}

std::string output(const std::string &statements) {
  return "StartOutputPass;\n" + statements + "\nEndPass;\n";
}
std::string prelim(const std::string &statements) {
  return "StartPrelimPass;\n" + statements + "\nEndPass;\n";
}
std::string constants(const std::string &statements) {
  return "StartConstants;\n" + statements + "\nEndConstants;\n";
}
const std::string kNop = output("MOV r0, 0;");

void accepts(const std::string &body, const CompileOptions &options = eightUnits()) {
  const std::string text = "!!ATIfs1.0\n" + body;
  const CheckResult result = check(text, options);
  EXPECT_TRUE(result.ok()) << text << result.errorString(text);
  EXPECT_TRUE(result.diagnostics.empty());
}

/// Expects exactly one error, with this ID, at the '@'.
void refuses(const std::string &id, const std::string &body,
             const CompileOptions &options = eightUnits()) {
  std::string text = body.starts_with('\n') ? body.substr(1) : "!!ATIfs1.0\n" + body;
  const std::size_t position = text.find('@');
  ASSERT_NE(position, std::string::npos) << text;
  text.erase(position, 1);
  const CheckResult result = check(text, options);
  ASSERT_FALSE(result.ok()) << text;
  EXPECT_EQ(result.diagnostics.at(0).id, id) << text << result.errorString(text);
  EXPECT_EQ(result.errorPosition(), std::int32_t(position)) << text << result.errorString(text);
  EXPECT_EQ(result.diagnostics.size(), 1u) << text << result.errorString(text);
}

TEST(AtiText, Header) {
  accepts(kNop);
  accepts("# !!ARBfp1.0 \xff\r" + kNop + "# the end");
  EXPECT_TRUE(check("!!ATIfs1.0StartOutputPass;EndPass;").ok());
  refuses("header_missing", "\n@ !!ATIfs1.0\n" + kNop);
  refuses("header_missing", "\n!!A@RBfp1.0\nEND");
  refuses("header_missing", "\n!!ATIfs1.@1\n" + kNop);
  EXPECT_EQ(check("").errorPosition(), 0);
}

TEST(AtiText, Blocks) {
  accepts(output(""));
  accepts(constants("") + kNop);
  accepts(prelim("MOV r0, 0;") + output(""));
  accepts(constants("CONSTANT c0 = {1};") + prelim("MOV r0, c0;") + kNop);
  refuses("ati_output_pass", "@");
  refuses("ati_output_pass", "@MOV r0, 0;");
  refuses("ati_output_pass", prelim("MOV r0, 0;") + "@");
  refuses("ati_output_pass", prelim("MOV r0, 0;") + "@" + prelim("MOV r0, 0;") + kNop);
  refuses("ati_output_pass", constants("") + "@" + constants("") + kNop);
  refuses("text_after_end", kNop + "@" + kNop);
  refuses("text_after_end", kNop + "@END");
  refuses("ati_pass_open", "StartOutputPass;\nMOV r0, 0;\n@");
  refuses("ati_pass_open", "StartPrelimPass;\nMOV r0, 0;\n@" + kNop);
  refuses("syntax", "StartConstants;\n@" + kNop);
  refuses("syntax", "StartOutputPass@\nMOV r0, 0;\nEndPass;");
  refuses("syntax", "StartOutputPass;\nMOV r0, 0;\nEndPass@");
  refuses("syntax", output("@CONSTANT c0 = {1};"));
  const std::string nul = "!!ATIfs1.0\n" + kNop + std::string(1, '\0');
  EXPECT_TRUE(check(nul).ok());
  EXPECT_EQ(check(nul).diagnostics.at(0).id, std::string("trailing_nul"));
}

TEST(AtiText, Constants) {
  accepts(constants("CONSTANT c0 = program.env[0]; CONSTANT c7 = program.local[7];") + kNop);
  accepts(constants("CONSTANT c1 = {0.5}; CONSTANT c2 = {0, 1.}; CONSTANT c3 = {.25,0.5,1e-3};") +
          kNop);
  accepts(constants("CONSTANT c1 = { 1.0, 0.0, 0.5, 0.75 };") + kNop);
  refuses("syntax", constants("CONSTANT @c8 = {1};") + kNop);
  refuses("syntax", constants("CONSTANT @r0 = {1};") + kNop);
  refuses("syntax", constants("@c0 = {1};") + kNop);
  refuses("syntax", constants("CONSTANT c0 @{1};") + kNop);
  refuses("syntax", constants("CONSTANT c0 = @1;") + kNop);
  refuses("syntax", constants("CONSTANT c0 = {@};") + kNop);
  refuses("syntax", constants("CONSTANT c0 = {1 @1};") + kNop);
  refuses("syntax", constants("CONSTANT c0 = {1,1,1,1@,1};") + kNop);
  refuses("syntax", constants("CONSTANT c0 = program.@param[1];") + kNop);
  refuses("syntax", constants("CONSTANT c0 = program.env[@1.0];") + kNop);
  refuses("syntax", constants("CONSTANT c0 = program.env[@c0];") + kNop);
  refuses("syntax", constants("CONSTANT c0 = {1}@ CONSTANT c1 = {1};") + kNop);
  refuses("parameter_index", constants("CONSTANT c0 = program.env[@8];") + kNop);
  refuses("parameter_index", constants("CONSTANT c0 = program.local[@4294967296];") + kNop);
  refuses("ati_constant_range", constants("CONSTANT c0 = {@1.5};") + kNop);
  refuses("ati_constant_range", constants("CONSTANT c0 = {0, @-0.5};") + kNop);
  CompileOptions four = eightUnits();
  four.limits.envParameters = 4;
  accepts(constants("CONSTANT c0 = program.env[3];") + kNop, four);
  refuses("parameter_index", constants("CONSTANT c0 = program.env[@4];") + kNop, four);
}

TEST(AtiText, LiteralsFillUpWithZeroZeroZeroOne) {
  const auto value = [](const std::string &literal) {
    const std::string text = "!!ATIfs1.0\n" + constants("CONSTANT c0 = " + literal + ";") + kNop;
    return parse(text, eightUnits()).shader.value().constants[0].value;
  };
  EXPECT_EQ(value("{0.5}"), (ir::Vec4{0.5f, 0.0f, 0.0f, 1.0f}));
  EXPECT_EQ(value("{0.5,0.25}"), (ir::Vec4{0.5f, 0.25f, 0.0f, 1.0f}));
  EXPECT_EQ(value("{0.5,0.25,1}"), (ir::Vec4{0.5f, 0.25f, 1.0f, 1.0f}));
  EXPECT_EQ(value("{0.5,0.25,1,0}"), (ir::Vec4{0.5f, 0.25f, 1.0f, 0.0f}));
}

TEST(AtiText, Setups) {
  accepts(output("SampleMap r0, t0.str; PassTexCoord r1, t1.stq; SampleMap r2, t2.str_dr;\n"
                 "PassTexCoord r3, t5.stq_dq;"));
  accepts(output("SampleMap r0 t0.str;")); // the printed grammar has no comma
  refuses("ati_setup_order", output("MOV r0, 0;\n@SampleMap r1, t0.str;"));
  refuses("syntax", output("SampleMap @t0, t0.str;"));
  refuses("syntax", output("SampleMap r0, @c0.str;"));
  refuses("syntax", output("SampleMap r0, t0@;"));
  refuses("syntax", output("SampleMap r0, t0.str@.str;"));
  refuses("ati_coordinates", output("SampleMap r0, t0.@strq;"));
  refuses("ati_coordinates", output("SampleMap r0, t0.@rgb;"));
  refuses("unknown_instruction", output("@SampleMapATI r0, t0.str;"));
}

TEST(AtiText, Destinations) {
  accepts(output("MOV r0, 0; MOV r1.r, 0; MOV r2.rga, 0; MOV r5.rgba, 0;"));
  accepts(output("MOV r0.2x, 0; MOV r0.rg.8x, 0; MOV r0.sat, 0; MOV r0.ba.eighth.sat, 0;"));
  accepts(output("MOV r0 0;")); // the printed grammar has no comma
  refuses("syntax", output("MOV @c0, 0;"));
  refuses("syntax", output("MOV @color0, 0;"));
  refuses("syntax", output("MOV r0.@, 0;"));
  refuses("ati_register", output("MOV @r6, 0;"));
  refuses("ati_register", output("MOV r0, @r6;"));
  refuses("syntax", output("MOV @r06, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.@gr, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.@rr, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.@xyz, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.@3x, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.r.@g, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.2x.@rgb, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.2x.@4x, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.sat.@2x, 0;"));
  refuses("ati_destination_suffix", output("MOV r0.sat.@sat, 0;"));
}

TEST(AtiText, Arguments) {
  accepts(output("MOV r0, r1.neg.2x.bias.comp; MOV r0, r1.r.neg; MOV r0, 1.2x; MOV r0, 0.comp;"));
  accepts(output("MOV r0, 1.a.2x; MOV r0, color0.b.comp; MOV r0,r1 .g . bias;"));
  accepts(output("MAD r0, r1, r2, r3; DOT3 r0, r1, r2; LERP r0, r1, r2, r3;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.bias.@2x;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.neg.@neg;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.neg.@r;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.@rgb;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.@4x;"));
  refuses("ati_argument_suffix", output("MOV r0, r1.@sat;"));
  refuses("syntax", output("MOV r0, @2;"));
  refuses("syntax", output("MOV r0, @t0;"));
  refuses("syntax", output("MOV r0, @c8;"));
  refuses("syntax", output("MOV r0, @color2;"));
  refuses("invalid_character", output("MOV r0, @(r1);"));
  refuses("syntax", output("MOV r0, @-r1;"));
  refuses("syntax", output("MOV r0, r1@, r2;"));
  refuses("syntax", output("ADD r0, r1@;"));
  refuses("syntax", output("ADD r0, r1 @r2;"));
  refuses("syntax", output("MAD r0, r1, r2@;"));
  refuses("syntax", output("DOT2ADD r0, r1, r2, r3@, r4;"));
  refuses("unknown_instruction", output("@mov r0, r1;"));
  refuses("unknown_instruction", output("@DP3 r0, r1, r2;"));
  refuses("syntax", output("@;"));
}

TEST(AtiRules, R01ConstantsAreDeclaredOnce) {
  accepts(constants("CONSTANT c3 = {1};") + output("MOV r0, c3;"));
  refuses("ati_constant_undeclared", output("MOV r0, @c3;"));
  refuses("ati_constant_undeclared", constants("CONSTANT c3 = {1};") + output("MOV r0, @c2;"));
  refuses("ati_constant_redeclared",
          constants("CONSTANT c3 = {1}; CONSTANT @c3 = program.env[0];") + kNop);
}

TEST(AtiRules, R02TwoDifferentConstants) {
  const std::string three =
      constants("CONSTANT c0 = {1}; CONSTANT c1 = {1}; CONSTANT c2 = program.env[0];");
  accepts(three + output("MAD r0, c0, c1, c0; MAD r0, c2, c2, c2; MAD r0, c0, r0, c1;"));
  accepts(three + output("MAD r0.rgb, c0, c1, r0; MAD r0.a, c2, c2, r0;"));
  accepts(three + output("MAD r0, c0, c1, 1;"));
  refuses("ati_constant_count", three + output("MAD r0, c0, c1, @c2;"));
  refuses("ati_constant_count", three + output("MAD r0, c0.r, c1.neg, @c2.bias;"));
}

TEST(AtiRules, R03ColorsInTheOutputPass) {
  accepts(output("MUL r0.rgb, color0, color1;"));
  accepts(prelim("MOV r0, 0;") + output("MUL r0.rgb, color0, color1;"));
  refuses("ati_color_in_prelim_pass", prelim("MOV r0, @color0;") + kNop);
  refuses("ati_color_in_prelim_pass", prelim("MOV r0.rgb, @color1;") + kNop);
}

TEST(AtiRules, R04APreliminaryPassHasAnInstruction) {
  accepts(prelim("SampleMap r0, t0.str; MOV r0, r0;") + kNop);
  refuses("ati_prelim_pass_empty", "StartPrelimPass;\nSampleMap r0, t0.str;\n@EndPass;\n" + kNop);
  refuses("ati_prelim_pass_empty", "StartPrelimPass;@EndPass;\n" + kNop);
}

std::string repeated(const std::string &statement, int count) {
  std::string all;
  while (count-- > 0)
    all += statement + "\n";
  return all;
}

TEST(AtiRules, R05EightPairs) {
  const std::string whole = "MOV r0, r1;", color = "MOV r0.rgb, r1;", alpha = "MOV r0.a, r1;";
  accepts(prelim(repeated(whole, 8)) + output(repeated(whole, 8)));
  accepts(output(repeated(color + alpha, 8)));
  accepts(output(repeated(color, 8) + alpha));
  // Alpha before colour is not a pair, and neither is alpha after a whole instruction.
  accepts(output(repeated(alpha + color, 7) + alpha));
  refuses("ati_pairs", output(repeated(alpha + color, 7) + alpha + "@" + color));
  refuses("ati_pairs", output(repeated(alpha + whole, 4) + "@" + alpha));
  refuses("ati_pairs", output(repeated(whole, 8) + "@" + alpha));
  refuses("ati_pairs", output(repeated(color, 8) + "@" + color));
  refuses("ati_pairs", output(repeated(color + alpha, 8) + "@" + alpha + whole + whole));
  refuses("ati_pairs", prelim(repeated(whole, 8) + "@" + whole) + kNop);
  // Setups do not count as pairs.
  accepts(output("SampleMap r0, t0.str; SampleMap r1, t1.str;" + repeated(whole, 8)));
}

TEST(AtiRules, R06ARegisterIsSetUpOnceInAPass) {
  accepts(prelim("SampleMap r0, t0.str; MOV r0, r0;") + output("SampleMap r0, t0.str;"));
  accepts(output("SampleMap r0, t0.str; MOV r0, 0; MOV r0, 1;"));
  refuses("ati_setup_twice", output("SampleMap r0, t0.str; PassTexCoord @r0, t1.str;"));
}

TEST(AtiRules, R07RegistersAreSourcesInTheSecondPassOnly) {
  accepts(prelim("MOV r1, 0;") + output("SampleMap r0, r1.str; PassTexCoord r1, r2.str_dr;"));
  refuses("ati_register_source", prelim("SampleMap r0, @r1.str; MOV r1, 0;") + kNop);
  refuses("ati_register_source", output("PassTexCoord r0, @r0.str;"));
}

TEST(AtiRules, R08ATexCoordGivesOneThirdComponent) {
  accepts(output("SampleMap r0, t2.str; SampleMap r1, t2.str_dr; PassTexCoord r2, t1.stq;\n"
                 "SampleMap r3, t1.stq_dq;"));
  refuses("ati_coordinate_conflict", output("SampleMap r0, t2.str; SampleMap r1, t2.@stq;"));
  refuses("ati_coordinate_conflict", output("SampleMap r0, t2.stq_dq; SampleMap r1, t2.@str_dr;"));
  refuses("ati_coordinate_conflict",
          prelim("SampleMap r0, t2.str; MOV r0, r0;") + output("PassTexCoord r0, t2.@stq_dq;"));
}

TEST(AtiRules, R09RegistersHaveNoQ) {
  accepts(prelim("MOV r0, 0;") + output("PassTexCoord r0, r0.str; SampleMap r1, r0.str_dr;"));
  refuses("ati_register_coordinates", prelim("MOV r0, 0;") + output("SampleMap r0, r0.@stq;"));
  refuses("ati_register_coordinates",
          prelim("MOV r0, 0;") + output("PassTexCoord r0, r0.@stq_dq;"));
}

TEST(AtiRules, R10DotsNeedAColor) {
  accepts(output("DOT3 r0.ra, r1, r2; DOT4 r0.rgba, r1, r2; DOT2ADD r0, r1, r2, r3;"));
  refuses("ati_dot_alpha", output("DOT3 r0.@a, r1, r2;"));
  refuses("ati_dot_alpha", output("DOT2ADD r0.@a.2x, r1, r2, r3;"));
  refuses("ati_dot_alpha", output("DOT4 r0.rgb, r1, r2; DOT4 r0.@a, r1, r2;"));
}

TEST(AtiRules, R11NoAlphaAfterADot4ThatLeavesItOut) {
  accepts(output("DOT4 r0, r1, r2; MOV r0.a, r1;"));
  accepts(output("DOT4 r0.ra, r1, r2; MOV r0.a, r1;"));
  accepts(output("DOT4 r0.rgb, r1, r2; MOV r0, r1; MOV r0.a, r1;"));
  accepts(output("DOT4 r0.rgb, r1, r2; MOV r0.r, r1; MOV r0.a, r1;"));
  accepts(output("DOT3 r0.rgb, r1, r2; MOV r0.a, r1;"));
  accepts(prelim("DOT4 r0.rgb, r1, r2;") + output("MOV r0.a, r1;"));
  refuses("ati_alpha_after_dot", output("DOT4 r0.rgb, r1, r2; MOV r0.@a, r1;"));
  refuses("ati_alpha_after_dot", output("DOT4 r3.g, r1, r2; MUL r0.@a.2x.sat, r1, r1;"));
}

TEST(AtiRules, R12TheSecondaryColorHasNoAlpha) {
  accepts(output("MOV r0.rgb, color1; MOV r0, color1.g; MOV r0.a, color1.b;"));
  accepts(output("DOT3 r0, color1, r1; DOT2ADD r0, color1, color1, color1;"));
  accepts(output("DOT4 r0, color1.r, r1;"));
  refuses("ati_secondary_alpha", output("MOV r0, @color1;"));
  refuses("ati_secondary_alpha", output("MOV r0.ra, @color1;"));
  refuses("ati_secondary_alpha", output("MOV r0.a, @color1;"));
  refuses("ati_secondary_alpha", output("MOV r0.rgb, @color1.a;"));
  refuses("ati_secondary_alpha", output("MAD r0, r1, r2, @color1.neg;"));
  refuses("ati_secondary_alpha", output("DOT4 r0.rgb, r1, @color1;"));
  refuses("ati_secondary_alpha", output("DOT3 r0.rgb, r1, @color1.a;"));
}

TEST(AtiRules, R13RegistersHaveATextureUnit) {
  CompileOptions four = eightUnits();
  four.limits.textureImageUnits = 4;
  accepts(output("SampleMap r3, t3.str; MOV r0, r3;"), four);
  accepts(output("MOV r0, r5;"));
  refuses("ati_register_unit", output("MOV r0, @r4;"), four);
  refuses("ati_register_unit", output("MOV @r5, r0;"), four);
  refuses("ati_register_unit", output("SampleMap @r4, t0.str;"), four);
}

TEST(AtiRules, UnitsOfFixedFunctionAreNotCounted) {
  CompileOptions four = eightUnits();
  four.limits.textureUnits = 4; // as NVIDIA's drivers say
  accepts(output("SampleMap r5, t5.str; MOV r0, r5;"), four);
}

TEST(AtiRules, R14TexCoordsHaveATextureUnit) {
  CompileOptions four = eightUnits();
  four.limits.textureCoords = 4;
  accepts(output("SampleMap r0, t3.str;"), four);
  accepts(output("SampleMap r0, t5.str;"));
  refuses("texcoord_index", output("SampleMap r0, @t4.str;"), four);
  refuses("texcoord_index", output("SampleMap r0, @t6.str;"));
}

TEST(AtiText, AllErrorsAreFoundInTextOrder) {
  const std::string text = "!!ATIfs1.0\n" + prelim("MOV r0, color0;\nFOO;\nMOV r9, 0;") +
                           output("MOV r0, c1;\nMOV r0.a.a, 0;\nSampleMap r0, r1.stq;");
  std::vector<std::string> ids;
  for (const Diagnostic &diagnostic : check(text).diagnostics)
    ids.push_back(diagnostic.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"ati_color_in_prelim_pass", "unknown_instruction",
                                           "ati_register", "ati_constant_undeclared",
                                           "ati_destination_suffix", "ati_setup_order",
                                           "ati_register_coordinates"}));
}

TEST(AtiText, HintsSuggestWords) {
  const auto hint = [](const std::string &body) {
    return check("!!ATIfs1.0\n" + body).diagnostics.at(0).hint;
  };
  EXPECT_NE(hint(output("SampleMapATI r0, t0.str;")).find("SampleMap"), std::string::npos);
  EXPECT_NE(hint(output("DOT2_ADD r0, r0, r0, r0;")).find("DOT2ADD"), std::string::npos);
  EXPECT_NE(hint(output("MOV r0.quater, r0;")).find("quarter"), std::string::npos);
  EXPECT_NE(hint("StartoutputPass;").find("StartOutputPass"), std::string::npos);
}

TEST(AtiText, Counts) {
  const std::string text =
      "!!ATIfs1.0\n" + constants("CONSTANT c0 = {1}; CONSTANT c1 = program.env[1];") +
      prelim("SampleMap r1, t0.str; PassTexCoord r2, t1.str; MOV r1.rgb, r2; MOV r1.a, r2;") +
      output("SampleMap r0, r1.str; MUL r0, r0, color0; ADD r0, r0, c0;");
  const CheckResult result = check(text);
  ASSERT_TRUE(result.ok()) << result.errorString(text);
  EXPECT_EQ(result.counts.aluInstructions, 3u);
  EXPECT_EQ(result.counts.texInstructions, 2u);
  EXPECT_EQ(result.counts.instructions, 5u);
  EXPECT_EQ(result.counts.texIndirections, 2u);
  EXPECT_EQ(result.counts.temporaries, 3u);
  EXPECT_EQ(result.counts.parameters, 2u);
  EXPECT_EQ(result.counts.attribs, 3u);
  EXPECT_TRUE(result.underNativeLimits);
}

} // namespace
} // namespace arbiter::fp::ati
