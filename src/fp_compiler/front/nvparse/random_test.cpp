// Tests random states written as texts and read back, and damaged texts.
#include "fp_compiler/front/nvparse/testing/parsed_text.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/random_combiners.h"
#include "fp_compiler/testing/random_texture_shaders.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::nvparse {
namespace {

constexpr std::uint64_t kStates = 2000;

/// Returns the part of a stage that a text can express for its operation.
texture_shader::Stage spelled(const texture_shader::Stage &stage) {
  const texture_shader::Family family = texture_shader::infoOf(stage.operation).family;
  texture_shader::Stage result;
  result.operation = stage.operation;
  if (family == texture_shader::Family::Cull)
    result.cullLess = stage.cullLess;
  if (texture_shader::readsPrevious(family))
    result.previous = stage.previous;
  if (texture_shader::computesDot(family))
    result.mapping = stage.mapping;
  return result;
}

ir::Vec4 randomValue(testing::Random &random, float least) {
  ir::Vec4 value;
  for (float &c : value)
    c = random.real(least, 1.0f);
  return value;
}

Text randomText(std::uint64_t seed, bool shaders, bool combiners) {
  testing::Random random(seed);
  Text text;
  testing::RandomCombinersOptions options;
  if (shaders) {
    text.shaders = testing::randomTextureShaders(random, 1 + random.below(8));
    options.units = text.shaders->units;
    options.textures = std::uint8_t((1u << unsigned(options.units)) - 1u);
  }
  if (combiners) {
    // The text also has the factors of a product that nothing reads.
    text.combiners = testing::randomCombiners(random, options);
    for (int which = 0; which < 2; ++which) {
      const bool perStage = text.combiners->perStageConstants;
      if (random.chance(50) && !perStage)
        text.values[std::size_t(combiners::globalConstant(which))] = randomValue(random, 0);
      for (int stage = 0; stage < text.combiners->count && perStage; ++stage)
        if (random.chance(50))
          text.values[std::size_t(combiners::stageConstant(stage, which))] = randomValue(random, 0);
    }
  }
  return text;
}

class Texts : public ::testing::TestWithParam<std::pair<bool, bool>> {};

TEST_P(Texts, StatesComeBack) {
  const auto [shaders, combiners] = GetParam();
  for (std::uint64_t seed = 0; seed < kStates; ++seed) {
    const Text text = randomText(seed, shaders, combiners);
    const std::string written = write(text);
    const ParseResult parsed =
        parse(shaders ? ir::Language::TextureShaders : ir::Language::Combiners, written,
              wholeCard(shaders ? text.shaders->units : 8));
    ASSERT_TRUE(parsed.text) << "seed " << seed << "\n"
                             << written << renderAll("text", written, parsed.diagnostics);
    ASSERT_EQ(parsed.text->combiners.has_value(), combiners);
    if (combiners) {
      EXPECT_TRUE(*text.combiners == *parsed.text->combiners) << "seed " << seed << "\n" << written;
    }
    if (shaders) {
      ASSERT_EQ(parsed.text->shaders->units, text.shaders->units);
      for (std::size_t unit = 0; unit < texture_shader::kUnits; ++unit)
        EXPECT_TRUE(spelled(text.shaders->stages[unit]) == parsed.text->shaders->stages[unit])
            << "seed " << seed << ", unit " << unit << "\n"
            << written;
    }
    EXPECT_EQ(text.values, parsed.text->values) << "seed " << seed << "\n" << written;
    EXPECT_EQ(write(*parsed.text), written);
    if (HasFailure())
      return;
  }
}
INSTANTIATE_TEST_SUITE_P(All, Texts,
                         ::testing::Values(std::pair(false, true), std::pair(true, false),
                                           std::pair(true, true)));

TEST(NvparseTexts, MatricesScalesAndEyesComeBack) {
  const std::string text = "!!TS1.0\n"
                           "texture_2d();\n"
                           "offset_2d_scale(tex0, 1.0, -0.5, 0.25, 0.1, 2.0, -1.0);\n"
                           "offset_hilo_rectangle(tex0, 0.0, 1.0, 1.0, 0.0);\n"
                           "texture_2d();\n"
                           "dot_product_cube_map_and_reflect_cube_map_const_eye_1of3(expand(tex3), "
                           "0.0, 0.3333333, -1.0);\n"
                           "dot_product_cube_map_and_reflect_cube_map_const_eye_2of3(tex3);\n"
                           "dot_product_cube_map_and_reflect_cube_map_const_eye_3of3(tex3);\n";
  const ParseResult parsed = parse(ir::Language::TextureShaders, text, wholeCard());
  ASSERT_TRUE(parsed.text) << renderAll("text", text, parsed.diagnostics);
  EXPECT_EQ(write(*parsed.text), text);
}

/// Checks what must hold for every result.
void expectSound(const std::string &text) {
  const auto language = languageOfText(text).value_or(ir::Language::Combiners);
  const CheckResult result = checkProgram(language, text, wholeCard());
  EXPECT_EQ(result.ok(), result.errorPosition() < 0) << text;
  EXPECT_LE(result.errorPosition(), std::int32_t(text.size())) << text;
  EXPECT_LE(result.diagnostics.size(), 2 * kMaxDiagnostics);
  if (result.ok()) {
    EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
  }
}

TEST(NvparseTexts, EveryEditOfATextHasAnAnswer) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = write(randomText(seed, seed % 2 == 0, seed % 3 != 0));
    testing::Random random(seed);
    for (std::size_t length = 0; length <= text.size(); length += 1 + random.below(19))
      expectSound(text.substr(0, length));
    for (int i = 0; i < 100; ++i) {
      std::string edited = text;
      if (text.empty())
        break;
      const auto at = std::size_t(random.below(int(text.size())));
      switch (random.below(3)) {
      case 0:
        edited.erase(at, std::size_t(1 + random.below(12)));
        break;
      case 1:
        edited.insert(at, text.substr(std::size_t(random.below(int(text.size()))), 8));
        break;
      default:
        edited[at] = char(random.below(256));
      }
      expectSound(edited);
    }
  }
}

TEST(NvparseTexts, DiagnosticsAreBounded) {
  for (const char *const header : {"!!RC1.0\n", "!!TS1.0\n"}) {
    std::string text = header;
    for (int i = 0; i < 5000; ++i)
      text += "{ rgb { foo = 1; } foo(); }\n";
    const auto language = *languageOfText(text);
    EXPECT_LE(parse(language, text, wholeCard()).diagnostics.size(), kMaxDiagnostics);
    const std::string longest(kMaxTextBytes + 1, ' ');
    EXPECT_EQ(parse(language, longest, wholeCard()).diagnostics.at(0).id,
              std::string("text_too_long"));
  }
}

} // namespace
} // namespace arbiter::fp::nvparse
