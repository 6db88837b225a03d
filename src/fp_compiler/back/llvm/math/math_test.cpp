// Error bounds of the functions: dense samples of their ranges, for every processor type that this
// machine can run.

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::Opcode;

struct Case {
  const char *name;
  Opcode op;
  /// Returns the operands of a sample.
  std::function<std::array<float, 2>(testing::Random &)> operands;
  std::function<double(double, double)> exact;
  double bound;
  bool relative = true;
};

/// Returns a positive number with any exponent in [low, high].
float anySize(testing::Random &random, int low, int high) {
  return std::ldexp(random.real(1, 2) + random.real(0, 0x1p-10f), low + random.below(high - low));
}
float between(testing::Random &random, float low, float high) {
  return random.real(low, high) + random.real(0, (high - low) / 1024);
}
float signedAngle(testing::Random &random, int high) {
  const float angle = anySize(random, -20, high);
  return random.chance(50) ? -angle : angle;
}

constexpr double kBound = 0x1p-22;
constexpr double kExp2Bound = 0x1.2p-22; // llvmpipe's is 2^-21.8

std::vector<Case> cases() {
  return {
      {"EX2", Opcode::Ex2,
       [](testing::Random &r) {
         return std::array{between(r, -126, 128), 0.0f};
       },
       [](double a, double) { return std::exp2(a); }, kExp2Bound},
      {"EX2 near 0", Opcode::Ex2,
       [](testing::Random &r) {
         return std::array{signedAngle(r, 0), 0.0f};
       },
       [](double a, double) { return std::exp2(a); }, kExp2Bound},
      {"LG2", Opcode::Lg2,
       [](testing::Random &r) {
         return std::array{anySize(r, -126, 128), 0.0f};
       },
       [](double a, double) { return std::log2(a); }, kBound},
      {"LG2 near 1", Opcode::Lg2,
       [](testing::Random &r) {
         return std::array{between(r, 0.5f, 2), 0.0f};
       },
       [](double a, double) { return std::log2(a); }, kBound},
      {"SIN", Opcode::Sin,
       [](testing::Random &r) {
         return std::array{signedAngle(r, 4), 0.0f};
       },
       [](double a, double) { return std::sin(a); }, kBound},
      {"COS", Opcode::Cos,
       [](testing::Random &r) {
         return std::array{signedAngle(r, 4), 0.0f};
       },
       [](double a, double) { return std::cos(a); }, kBound},
      {"SIN to 2^22", Opcode::Sin,
       [](testing::Random &r) {
         return std::array{signedAngle(r, 22), 0.0f};
       },
       [](double a, double) { return std::sin(a); }, 0x1p-23, false},
      {"COS to 2^22", Opcode::Cos,
       [](testing::Random &r) {
         return std::array{signedAngle(r, 22), 0.0f};
       },
       [](double a, double) { return std::cos(a); }, 0x1p-23, false},
      {"POW", Opcode::Pow,
       [](testing::Random &r) {
         const float base = anySize(r, -30, 30);
         const float reach = 125 / std::max(1.0f, std::fabs(std::log2(base)));
         return std::array{base, between(r, -reach, reach)};
       },
       [](double a, double b) { return std::exp2(b * std::log2(a)); }, kBound},
      {"POW of a highlight", Opcode::Pow,
       [](testing::Random &r) {
         return std::array{between(r, 0.5f, 1), between(r, 1, 120)};
       },
       [](double a, double b) { return std::exp2(b * std::log2(a)); }, kBound},
      {"POW, large, of 1 or so", Opcode::Pow,
       [](testing::Random &r) {
         const float base = between(r, 0.95f, 1.05f);
         const float reach = std::min(2000.0f, 120 / std::fabs(std::log2(base)));
         return std::array{base, between(r, -reach, reach)};
       },
       [](double a, double b) { return std::exp2(b * std::log2(a)); }, 0x1p-19},
      {"RCP", Opcode::Rcp,
       [](testing::Random &r) {
         return std::array{anySize(r, -125, 126), 0.0f};
       },
       [](double a, double) { return 1 / a; }, 0x1p-24},
      {"RSQ", Opcode::Rsq,
       [](testing::Random &r) {
         return std::array{anySize(r, -126, 128), 0.0f};
       },
       [](double a, double) { return 1 / std::sqrt(a); }, kBound},
  };
}

class MathTest : public ::testing::TestWithParam<std::string> {};

TEST_P(MathTest, IsAsCloseAsItSays) {
  constexpr std::size_t kSamples = 50000;
  for (const Case &c : cases()) {
    ir::Builder b(ir::Language::ArbVertex);
    const ir::Target result = b.result(ir::OutputKind::FogCoord).mask("x");
    const ir::Source source = b.attribute(ir::AttributeKind::Generic, 1);
    if (ir::info(c.op).operandCount() == 1)
      b.op(c.op, result, {source.swz("x")});
    else
      b.op(c.op, result, {source.swz("x"), source.swz("y")});
    const TestMachine machine(b.program(), Numerics::Host, GetParam());
    ASSERT_EQ(machine.reason(), "");
    testing::Random random(7);
    std::vector<TestMachine::Attributes> lanes;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const auto [x, y] = c.operands(random);
      lanes.push_back({{x, y, 0, 0}});
    }
    const auto results = machine.run(lanes, {});
    double worst = 0;
    std::size_t where = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const double exact = c.exact(double(lanes[i][0][0]), double(lanes[i][0][1]));
      const double size = c.relative ? std::max(std::fabs(exact), 0x1p-126) : 1;
      const double error = std::fabs(double(results[i].outputs[0][0]) - exact) / size;
      if (!(error <= worst)) {
        worst = error;
        where = i;
      }
    }
    EXPECT_LE(worst, c.bound) << c.name << " of " << lanes[where][0][0] << ", "
                              << lanes[where][0][1] << " is " << results[where].outputs[0][0];
    RecordProperty(std::string("worst ") + c.name, std::to_string(std::log2(worst)));
    std::printf("%-20s worst error 2^%.2f\n", c.name, std::log2(worst));
  }
}

INSTANTIATE_TEST_SUITE_P(All, MathTest, ::testing::ValuesIn(testedCpus()),
                         [](const auto &param) { return nameInTests(param.param); });

} // namespace
} // namespace arbiter::fp::llvm_back
