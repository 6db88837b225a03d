#include "fp_compiler/front/ati/parser.h"

#include <gtest/gtest.h>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/front/ati/testing/eight_units.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::ati {
namespace {

TEST(AtiParser, TextMeansTheShader) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Shader shader = testing::randomAtiShader(seed);
    const std::string text = testing::spell(shader, seed);
    const ParseResult parsed = parse(text, eightUnits());
    ASSERT_TRUE(parsed.shader) << "seed " << seed << "\n"
                               << text << renderAll("text", text, parsed.diagnostics);
    EXPECT_EQ(ir::print(lower(shader)), ir::print(lower(*parsed.shader))) << text;
    if (HasFailure())
      return;
  }
}

TEST(AtiParser, SpansAreThoseOfTheText) {
  const std::string text = "!!ATIfs1.0\nStartOutputPass;\nSampleMap r0, t0.str;\n"
                           "MUL r0.rgb, r0, color0;\nMOV r0.a, 1;\nEndPass;\n";
  const ParseResult parsed = parse(text, eightUnits());
  ASSERT_TRUE(parsed.shader);
  const auto piece = [&](Span span) { return text.substr(span.begin, span.end - span.begin); };
  const Pass &pass = parsed.shader->passes[0];
  EXPECT_EQ(piece(pass.setups[0].span), "SampleMap r0, t0.str");
  EXPECT_EQ(piece(pass.pairs[0].span), "MUL r0.rgb, r0, color0");
  EXPECT_EQ(pass.pairCount, 1);
}

/// Checks what must hold for every result.
void expectSound(const std::string &text) {
  const CheckResult result = checkProgram(ir::Language::AtiFragment, text, eightUnits());
  EXPECT_EQ(result.ok(), result.errorPosition() < 0) << text;
  EXPECT_LE(result.errorPosition(), std::int32_t(text.size())) << text;
  if (result.ok()) {
    EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
  }
}

TEST(AtiParser, EveryEditOfATextHasAnAnswer) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = testing::spell(testing::randomAtiShader(seed), seed);
    testing::Random random(seed);
    for (std::size_t length = 0; length <= text.size(); length += 1 + random.below(9))
      expectSound(text.substr(0, length));
    for (int i = 0; i < 200; ++i) {
      std::string edited = text;
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

TEST(AtiParser, DiagnosticsAreBounded) {
  std::string text = "!!ATIfs1.0\nStartOutputPass;\n";
  for (int i = 0; i < 5000; ++i)
    text += "FOO r9;\n";
  EXPECT_LE(parse(text, eightUnits()).diagnostics.size(), kMaxDiagnostics);
  EXPECT_EQ(parse(std::string(kMaxTextBytes + 1, ' '), eightUnits()).diagnostics.at(0).id,
            std::string("text_too_long"));
}

} // namespace
} // namespace arbiter::fp::ati
