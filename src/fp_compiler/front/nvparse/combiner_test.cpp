#include "fp_compiler/front/nvparse/testing/parsed_text.h"
#include "fp_compiler/front/nvparse/words.h"

namespace arbiter::fp::nvparse {
namespace {

using combiners::Input;
using combiners::Mapping;
using combiners::Portion;
using combiners::Register;
using combiners::Scale;
using combiners::State;
using combiners::Usage;

struct ParsedCombiners : ParsedText {
  ParsedCombiners(const std::string &body, const CompileOptions &options = wholeCard())
      : ParsedText(ir::Language::Combiners, "!!RC1.0\n" + body, options) {}
  [[nodiscard]] const State &state() const { return *result.text->combiners; }
  [[nodiscard]] const std::optional<ir::Vec4> &value(int parameter) const {
    return result.text->values[std::size_t(parameter)];
  }
};

/// Returns the colour portion of the first stage. The text must parse.
Portion rgbOf(const std::string &block) {
  const ParsedCombiners parsed("{ rgb { " + block + " } } out.rgb = spare0;");
  EXPECT_TRUE(parsed.result.text) << parsed.said();
  return parsed.result.text ? parsed.state().stages[0].rgb : Portion{};
}

void expectError(const std::string &body, const char *id, const std::string &piece,
                 const CompileOptions &options = wholeCard()) {
  expectFinding(ParsedCombiners(body, options), id, piece);
}

TEST(CombinerText, EveryMappingOfAStage) {
  struct Row {
    const char *text;
    Mapping mapping;
  };
  constexpr Row kRows[] = {{"col0", Mapping::SignedIdentity},
                           {"-col0", Mapping::SignedNegate},
                           {"unsigned(col0)", Mapping::UnsignedIdentity},
                           {"unsigned_invert(col0)", Mapping::UnsignedInvert},
                           {"expand(col0)", Mapping::ExpandNormal},
                           {"-expand(col0)", Mapping::ExpandNegate},
                           {"half_bias(col0)", Mapping::HalfBiasNormal},
                           {"- half_bias ( col0 )", Mapping::HalfBiasNegate}};
  for (const Row &row : kRows) {
    const Portion portion = rgbOf(std::string("spare0 = ") + row.text + " * " + row.text + ";");
    const Input expected = {Register::Primary, row.mapping, Usage::Rgb};
    EXPECT_EQ(portion.inputs[0], expected) << row.text;
    EXPECT_EQ(portion.inputs[1], expected) << row.text;
  }
}

TEST(CombinerText, OneIsZeroInverted) {
  struct Row {
    const char *text;
    Mapping mapping;
  };
  constexpr Row kRows[] = {{"one", Mapping::UnsignedInvert},
                           {"-one", Mapping::ExpandNormal},
                           {"unsigned(one)", Mapping::UnsignedInvert},
                           {"unsigned_invert(one)", Mapping::UnsignedIdentity},
                           {"expand(one)", Mapping::UnsignedInvert},
                           {"-expand(one)", Mapping::ExpandNormal},
                           {"half_bias(one)", Mapping::HalfBiasNegate},
                           {"-half_bias(one)", Mapping::HalfBiasNormal}};
  for (const Row &row : kRows)
    EXPECT_EQ(rgbOf(std::string("spare0 = ") + row.text + ";").inputs[0],
              (Input{Register::Zero, row.mapping, Usage::Rgb}))
        << row.text;
}

TEST(CombinerText, EveryRegister) {
  struct Row {
    const char *word;
    Register name;
  };
  constexpr Row kRows[] = {{"zero", Register::Zero},        {"const0", Register::Constant0},
                           {"const1", Register::Constant1}, {"fog", Register::Fog},
                           {"col0", Register::Primary},     {"col1", Register::Secondary},
                           {"spare0", Register::Spare0},    {"spare1", Register::Spare1}};
  for (const Row &row : kRows) {
    EXPECT_EQ(rgbOf(std::string("discard = ") + row.word + ";").inputs[0].source, row.name);
    EXPECT_EQ(wordOf(row.name), row.word);
  }
  for (int unit = 0; unit < 8; ++unit) {
    const std::string word = "tex" + std::to_string(unit);
    const Portion portion = rgbOf(word + " = " + word + ".a;");
    EXPECT_EQ(portion.ab, combiners::textureRegister(unit));
    EXPECT_EQ(portion.inputs[0],
              (Input{combiners::textureRegister(unit), Mapping::SignedIdentity, Usage::Alpha}));
  }
}

TEST(CombinerText, ProductsSumsAndMuxes) {
  Portion portion = rgbOf("spare0 = col0;");
  EXPECT_EQ(portion.ab, Register::Spare0);
  EXPECT_EQ(portion.cd, Register::Discard);
  EXPECT_EQ(portion.sum, Register::Discard);
  EXPECT_EQ(portion.inputs[1], (Input{Register::Zero, Mapping::UnsignedInvert, Usage::Rgb}));
  EXPECT_EQ(portion.inputs[2], (Input{Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb}));
  portion = rgbOf("spare0 = expand(col0) . expand(tex1); spare1 = col1 * tex0;");
  EXPECT_TRUE(portion.abDot);
  EXPECT_FALSE(portion.cdDot);
  EXPECT_EQ(portion.cd, Register::Spare1);
  portion = rgbOf("discard = col0.rgb.tex0.rgb; discard = col1.a*tex1; spare0 = sum();");
  EXPECT_TRUE(portion.abDot);
  EXPECT_EQ(portion.inputs[2].usage, Usage::Alpha);
  EXPECT_EQ(portion.sum, Register::Spare0);
  EXPECT_FALSE(portion.mux);
  portion = rgbOf("discard = col0; discard = col1; spare1 = mux();");
  EXPECT_TRUE(portion.mux);
  EXPECT_EQ(portion.sum, Register::Spare1);
}

TEST(CombinerText, EveryScale) {
  struct Row {
    const char *word;
    Scale scale;
    bool bias;
  };
  constexpr Row kRows[] = {{"scale_by_two", Scale::ByTwo, false},
                           {"scale_by_four", Scale::ByFour, false},
                           {"scale_by_one_half", Scale::ByOneHalf, false},
                           {"bias_by_negative_one_half", Scale::None, true},
                           {"bias_by_negative_one_half_scale_by_two", Scale::ByTwo, true}};
  for (const Row &row : kRows) {
    const Portion portion = rgbOf(std::string("spare0 = col0; ") + row.word + "();");
    EXPECT_EQ(portion.scale, row.scale) << row.word;
    EXPECT_EQ(portion.bias, row.bias) << row.word;
  }
}

TEST(CombinerText, AlphaReadsAlphaAndBlue) {
  const ParsedCombiners parsed(
      "{ alpha { spare0 = col0 * fog.b; } } out.rgb = spare0.a; out.a = spare0.b;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  const Portion &alpha = parsed.state().stages[0].alpha;
  EXPECT_EQ(alpha.inputs[0].usage, Usage::Alpha);
  EXPECT_EQ(alpha.inputs[1], (Input{Register::Fog, Mapping::SignedIdentity, Usage::Blue}));
  EXPECT_EQ(parsed.state().finals[3],
            (Input{Register::Spare0, Mapping::UnsignedIdentity, Usage::Alpha}));
  EXPECT_EQ(parsed.state().finals[6],
            (Input{Register::Spare0, Mapping::UnsignedIdentity, Usage::Blue}));
  EXPECT_EQ(parsed.state().stages[0].rgb.sum, Register::Discard);
}

TEST(CombinerText, ConstantsOfAllStagesAndOfOne) {
  ParsedCombiners parsed(
      "const0 = (0.25, .5, 1, +0.75);\n{ rgb { spare0 = const0; } } out.rgb = const1;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_FALSE(parsed.state().perStageConstants);
  EXPECT_EQ(parsed.value(combiners::globalConstant(0)), (ir::Vec4{0.25f, 0.5f, 1.0f, 0.75f}));
  EXPECT_FALSE(parsed.value(combiners::globalConstant(1)));
  EXPECT_FALSE(parsed.value(combiners::stageConstant(0, 0)));
  parsed =
      ParsedCombiners("const0 = (1, 0, 0, 0); { const1 = (0, 1, 0, 0); rgb { spare0 = const1; } }"
                      "{ rgb { spare0 = const0; } } out.rgb = spare0;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_TRUE(parsed.state().perStageConstants);
  EXPECT_EQ(parsed.state().count, 2);
  EXPECT_EQ(parsed.value(combiners::stageConstant(0, 0)), (ir::Vec4{1, 0, 0, 0}));
  EXPECT_EQ(parsed.value(combiners::stageConstant(0, 1)), (ir::Vec4{0, 1, 0, 0}));
  EXPECT_EQ(parsed.value(combiners::stageConstant(1, 0)), (ir::Vec4{1, 0, 0, 0}));
  EXPECT_FALSE(parsed.value(combiners::stageConstant(1, 1)));
  parsed = ParsedCombiners("per_stage_constants(); { rgb { spare0 = const1; } } out.rgb = spare0;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_TRUE(parsed.state().perStageConstants);
}

TEST(CombinerText, ConstantsAreClampedWithAWarning) {
  const ParsedCombiners parsed("const0 = (-1, 0.5, 2, 1); out.rgb = const0;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_EQ(parsed.value(0), (ir::Vec4{0, 0.5f, 1, 1}));
  ASSERT_EQ(parsed.result.diagnostics.size(), 1u);
  EXPECT_EQ(parsed.result.diagnostics[0].id, std::string("combiner_range"));
}

TEST(CombinerText, EveryFormOfTheFinalColor) {
  const Input zero = {Register::Zero, Mapping::UnsignedIdentity, Usage::Rgb};
  const Input one = {Register::Zero, Mapping::UnsignedInvert, Usage::Rgb};
  const Input col0 = {Register::Primary, Mapping::UnsignedIdentity, Usage::Rgb};
  const Input col1 = {Register::Secondary, Mapping::UnsignedInvert, Usage::Rgb};
  const Input fog = {Register::Fog, Mapping::UnsignedIdentity, Usage::Rgb};
  const Input fogA = {Register::Fog, Mapping::UnsignedIdentity, Usage::Alpha};
  const Input sum = {Register::Spare0PlusSecondary, Mapping::UnsignedIdentity, Usage::Rgb};
  struct Row {
    const char *text;
    std::array<Input, 4> abcd;
  };
  const Row rows[] = {
      {"col0", {zero, zero, zero, col0}},
      {"unsigned(col0) * unsigned_invert(col1)", {col0, col1, zero, zero}},
      {"col0 * unsigned_invert(col1) + fog", {col0, col1, zero, fog}},
      {"col0 + fog", {col0, one, zero, fog}},
      {"lerp(fog.a, col0, fog)", {fogA, col0, fog, zero}},
      {"lerp(fog.a, col0, fog) + unsigned_invert(col1)", {fogA, col0, fog, col1}},
      {"unsigned_invert(col1) + lerp(fog.a, col0, fog)", {fogA, col0, fog, col1}},
      {"color_sum", {zero, zero, zero, sum}},
      {"color_sum * col0", {col0, sum, zero, zero}},
      {"color_sum + col0", {one, sum, zero, col0}},
      {"lerp(fog.a, color_sum, fog)", {fogA, sum, fog, zero}},
  };
  for (const Row &row : rows) {
    const ParsedCombiners parsed(std::string("out.rgb = ") + row.text + ";");
    ASSERT_TRUE(parsed.result.text) << parsed.said();
    for (std::size_t v = 0; v < 4; ++v)
      EXPECT_EQ(parsed.state().finals[v], row.abcd[v]) << row.text << ", variable " << v;
  }
}

TEST(CombinerText, ProductAndClampOfTheFinalCombiner) {
  const ParsedCombiners parsed(
      "clamp_color_sum();\nfinal_product = spare0 * unsigned_invert(tex1.a);\n"
      "out.rgb = final_product + color_sum; out.a = unsigned_invert(col0.b);");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_TRUE(parsed.state().sumClamp);
  EXPECT_EQ(parsed.state().finals[0].source, Register::ETimesF);
  EXPECT_EQ(parsed.state().finals[5],
            (Input{combiners::textureRegister(1), Mapping::UnsignedInvert, Usage::Alpha}));
  EXPECT_EQ(parsed.state().finals[6],
            (Input{Register::Primary, Mapping::UnsignedInvert, Usage::Blue}));
  EXPECT_FALSE(ParsedCombiners("out.rgb = col0;").state().sumClamp);
}

TEST(CombinerText, CommentsOfEveryForm) {
  const ParsedCombiners parsed(
      "# one\n// two\n/* three\n * more **/ out /* . */ . rgb = col0; // end");
  EXPECT_TRUE(parsed.result.text) << parsed.said();
  expectError("out.rgb = col0; /* open", "invalid_character", "/");
}

TEST(CombinerText, EveryMistakeHasItsPlace) {
  expectError("{ rgb { spare0 = discard; } } out.rgb = col0;", "combiner_register", "discard");
  expectError("{ rgb { const0 = col0; } } out.rgb = col0;", "combiner_register", "const0");
  expectError("{ rgb { fog = col0; } } out.rgb = col0;", "combiner_register", "fog");
  expectError("{ rgb { spare0 = fog.a; } } out.rgb = col0;", "combiner_register", "fog.a");
  expectError("{ alpha { spare0 = fog; } } out.rgb = col0;", "combiner_register", "fog");
  expectError("{ rgb { spare0 = color_sum; } } out.rgb = col0;", "combiner_register", "color_sum");
  expectError("{ rgb { spare0 = col0.b; } } out.rgb = col0;", "combiner_component", "col0.b");
  expectError("{ alpha { spare0 = col0.rgb; } } out.rgb = col0;", "combiner_component", "col0.rgb");
  expectError("{ rgb { spare0.a = col0; } } out.rgb = col0;", "combiner_component", "spare0.a");
  expectError("{ alpha { spare0 = col0 . col1; } } out.rgb = col0;", "combiner_dot", ".");
  expectError("{ rgb { spare0 = -unsigned(col0); } } out.rgb = col0;", "combiner_mapping",
              "unsigned");
  expectError("{ rgb { spare0 = col0; spare0 = col1; } } out.rgb = col0;", "combiner_outputs",
              "spare0");
  expectError("{ rgb { spare0 = col0; discard = col1; spare0 = sum(); } } out.rgb = col0;",
              "combiner_outputs", "spare0");
  expectError("{ rgb { spare0 = col0; spare1 = sum(); } } out.rgb = col0;", "combiner_block",
              "sum");
  expectError("{ rgb { spare0 = col0; spare1 = col1; tex0 = fog; } } out.rgb = col0;",
              "combiner_block", "tex0");
  expectError("{ rgb { } } out.rgb = col0;", "combiner_block", "}");
  expectError("{ } out.rgb = col0;", "combiner_block", "}");
  expectError("{ rgb { scale_by_two(); spare0 = col0; } } out.rgb = col0;", "combiner_block",
              "spare0");
  expectError("{ rgb { spare0 = col0; } rgb { spare0 = col0; } } out.rgb = col0;", "combiner_twice",
              "rgb");
  expectError("const0 = (0,0,0,0); const0 = (0,0,0,0); out.rgb = col0;", "combiner_twice",
              "const0");
  expectError("out.rgb = col0; out.rgb = col1;", "combiner_twice", "out");
  expectError("out.rgb = col0; { rgb { spare0 = col0; } }", "combiner_order", "{");
  expectError("{ rgb { spare0 = col0; } } const0 = (0,0,0,0); out.rgb = col0;", "combiner_order",
              "const0");
  expectError("out.rgb = final_product;", "combiner_final", "final_product");
  expectError("{ rgb { spare0 = col0; } }", "combiner_final", "");
  expectError("out.rgb = lerp(color_sum, col0, col1);", "combiner_register",
              "out.rgb = lerp(color_sum, col0, col1)");
  expectError("out.rgb = expand(col0);", "combiner_mapping", "expand");
  expectError("out.rgb = col0.b;", "combiner_component", "col0.b");
  expectError("out.a = col0.rgb;", "combiner_component", "col0.rgb");
  expectError("out.a = color_sum;", "combiner_register", "color_sum");
  expectError("final_product = color_sum * col0; out.rgb = col0;", "combiner_register",
              " = color_sum * col0");
  expectError("out.rgb = texture0;", "syntax", "texture0");
  expectError("out.rgb col0;", "syntax", "col0");
  expectError("out.rgb = col0", "syntax", "");
  expectError("out.alpha = col0;", "syntax", "alpha");
  expectError("const0 = (1, 2, 3); out.rgb = col0;", "syntax", ")");
  expectError("spare0 = col0; out.rgb = col0;", "syntax", "spare0");
  expectError("{ rgb { spare0 = col0; } ", "syntax", "");
  expectError("} out.rgb = col0;", "syntax", "}");
}

TEST(CombinerText, Limits) {
  CompileOptions options = wholeCard();
  options.limits.generalCombiners = 2;
  options.limits.perStageConstants = 0;
  options.limits.textureUnits = 2;
  const std::string stage = "{ rgb { spare0 = col0; } }\n";
  EXPECT_TRUE(ParsedCombiners(stage + stage + "out.rgb = spare0;", options).result.text);
  expectError(stage + stage + "{ rgb { spare0 = col1; } } out.rgb = col0;",
              "limit_general_combiners", "{", options);
  expectError("{ const0 = (0,0,0,0); rgb { spare0 = const0; } } out.rgb = col0;",
              "limit_stage_constants", "const0", options);
  expectError("out.rgb = tex2;", "image_unit", "tex2", options);
  options.policy = LimitPolicy::Report;
  const ParsedCombiners reported(stage + stage + stage + "out.rgb = tex3;", options);
  ASSERT_TRUE(reported.result.text) << reported.said();
  EXPECT_EQ(reported.state().count, 3);
  EXPECT_EQ(reported.result.diagnostics.size(), 2u);
  std::string nine;
  for (int i = 0; i < 9; ++i)
    nine += stage;
  expectError(nine + "out.rgb = col0;", "limit_general_combiners", "{");
  options = wholeCard();
  options.limits.generalCombiners = 0;
  expectError("out.rgb = col0;", "not_offered", "!!RC1.0", options);
}

} // namespace
} // namespace arbiter::fp::nvparse
