#include "fp_compiler/front/nvparse/testing/parsed_text.h"
#include "fp_compiler/front/nvparse/words.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::nvparse {
namespace {

using texture_shader::Operation;
using texture_shader::Row;

struct ParsedShaders : ParsedText {
  ParsedShaders(const std::string &body, const CompileOptions &options = wholeCard(4))
      : ParsedText(ir::Language::TextureShaders, "!!TS1.0\n" + body, options) {}
  [[nodiscard]] const texture_shader::State &state() const { return *result.text->shaders; }
  [[nodiscard]] const std::optional<ir::Vec4> &value(int unit, Row row) const {
    return result.text->values[std::size_t(texture_shader::parameter(unit, row))];
  }
};

void expectShaderFinding(const std::string &body, const char *id, const std::string &piece,
                         bool isError = true, const CompileOptions &options = wholeCard(4)) {
  expectFinding(ParsedShaders(body, options), id, piece, isError);
}

/// Tests each row as a text has it: within its run, after a texture.
TEST(ShaderText, EveryOperation) {
  for (const OperationWord &row : operationWords()) {
    std::string text = "texture_2d();\n";
    const int unit = row.stage;
    const OperationWord *const first = &row - (row.stage - 1);
    for (int i = 0; i < row.stages; ++i) {
      const OperationWord &each = first[i];
      text += std::string(each.word) + "(";
      if (each.arguments == Arguments::Cull)
        text += "LESS_THAN_ZERO, GEQUAL_TO_ZERO, GEQUAL_TO_ZERO, LESS_THAN_ZERO";
      else if (each.arguments != Arguments::None)
        text += "tex0";
      if (each.arguments == Arguments::Matrix)
        text += ", 1, 0.5, -.25, 2.0";
      else if (each.arguments == Arguments::Scale)
        text += ", 1, 2, 3, 4, 5, 6";
      else if (each.arguments == Arguments::Eye)
        text += ", 0, 1, -1";
      text += ");\n";
    }
    // An operation without a run may be refused at a unit that cannot have it.
    if (texture_shader::infoOf(row.operation).firstUnit > unit)
      continue;
    const ParsedShaders parsed(text);
    ASSERT_TRUE(parsed.result.text) << parsed.said();
    EXPECT_EQ(parsed.state().stages[std::size_t(unit)].operation, row.operation) << row.word;
    if (row.arguments == Arguments::Scale) {
      EXPECT_EQ(parsed.value(unit, Row::Matrix), (ir::Vec4{1, 2, 3, 4}));
      EXPECT_EQ(parsed.value(unit, Row::ScaleBias), (ir::Vec4{5, 6, 0, 0}));
    }
    if (row.arguments == Arguments::Matrix) {
      EXPECT_EQ(parsed.value(unit, Row::Matrix), (ir::Vec4{1, 0.5f, -0.25f, 2}));
    }
    if (row.arguments == Arguments::Eye) {
      EXPECT_EQ(parsed.value(unit + row.stages - 1, Row::Eye), (ir::Vec4{0, 1, -1, 0}));
    }
    if (row.arguments == Arguments::Cull) {
      EXPECT_EQ(parsed.state().stages[1].cullLess, 9);
    }
  }
}

TEST(ShaderText, MappingsAndWhatStagesRead) {
  const ParsedShaders parsed("texture_2d();\ntexture_2d();\ndot_product_2d_1of2(expand(tex1));\n"
                             "dot_product_2d_2of2(force_blue_to_one(tex0));");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_TRUE(parsed.result.diagnostics.empty()) << parsed.said();
  EXPECT_EQ(parsed.state().stages[2].mapping, texture_shader::Mapping::ExpandNormal);
  EXPECT_EQ(parsed.state().stages[2].previous, 1);
  EXPECT_EQ(parsed.state().stages[3].mapping, texture_shader::Mapping::ForceBlueToOne);
  EXPECT_EQ(parsed.state().stages[3].previous, 0);
}

TEST(ShaderText, NumbersMayBeLeftToTheApplication) {
  const ParsedShaders parsed("texture_2d(); offset_2d(tex0);");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  EXPECT_FALSE(parsed.value(1, Row::Matrix));
  EXPECT_EQ(parsed.state().textures[0].base, texture_shader::Base::Dsdt);
}

TEST(ShaderText, CombinersMayFollow) {
  const ParsedShaders parsed(
      "texture_2d();\n// what Cg wrote\n!!RC1.0\nout.rgb = tex0; out.a = tex0;");
  ASSERT_TRUE(parsed.result.text) << parsed.said();
  ASSERT_TRUE(parsed.result.text->combiners);
  EXPECT_EQ(parsed.result.text->combiners->finals[3].source, combiners::Register::Texture0);
}

TEST(ShaderText, EveryMistakeHasItsPlace) {
  expectShaderFinding("texture2d();", "shader_operation", "texture2d");
  expectShaderFinding("texture_2d(tex0);", "syntax", "tex0");
  expectShaderFinding("texture_2d()", "syntax", "");
  expectShaderFinding("texture_2d(); dependent_ar(tex1);", "shader_previous", "tex1");
  expectShaderFinding("dependent_ar(tex0);", "shader_previous", "dependent_ar");
  expectShaderFinding("texture_2d(); dependent_ar(col0);", "syntax", "col0");
  expectShaderFinding("texture_2d(); offset_2d(tex0, 1, 2, 3);", "syntax", ")");
  expectShaderFinding("cull_fragment(LESS_THAN_ZERO);", "syntax", ")");
  expectShaderFinding("cull_fragment(LESS);", "syntax", "LESS");
  expectShaderFinding("texture_2d(); dot_product_2d_2of2(tex0);", "shader_run",
                      "dot_product_2d_2of2");
  expectShaderFinding("texture_2d(); dot_product_3d_1of3(tex0); dot_product_2d_2of2(tex0);",
                      "shader_run", "dot_product_2d_2of2");
  expectShaderFinding("texture_2d(); dot_product_2d_1of2(tex0); texture_2d();", "shader_run",
                      "texture_2d");
  expectShaderFinding("texture_2d(); dot_product_2d_1of2(tex0);", "shader_run", "");
  expectShaderFinding("nop(); nop(); nop(); nop(); texture_2d();", "limit_shader_units",
                      "texture_2d");
  expectShaderFinding("texture_2d(); ! !", "syntax", "!");
  expectShaderFinding("nop(); dependent_ar(tex0);", "shader_inconsistent", "dependent_ar(tex0)",
                      false);
}

TEST(ShaderText, Extensions) {
  CompileOptions options = wholeCard(4);
  options.limits.textureShaders = 1;
  expectShaderFinding("texture_3d();", "limit_texture_shaders", "texture_3d", true, options);
  options.limits.textureShaders = 2;
  EXPECT_TRUE(ParsedShaders("texture_3d();", options).result.text);
  expectShaderFinding("texture_2d(); dot_product_1d(tex0);", "limit_texture_shaders",
                      "dot_product_1d", true, options);
  expectShaderFinding("texture_2d(); dot_product(force_blue_to_one(tex0));",
                      "limit_texture_shaders", "force_blue_to_one", true, options);
  options.policy = LimitPolicy::Report;
  EXPECT_TRUE(ParsedShaders("texture_2d(); dot_product_1d(tex0);", options).result.text);
  options.policy = LimitPolicy::Enforce;
  options.limits.textureShaders = 0;
  expectShaderFinding("texture_2d();", "not_offered", "!!TS1.0", true, options);
}

} // namespace
} // namespace arbiter::fp::nvparse
