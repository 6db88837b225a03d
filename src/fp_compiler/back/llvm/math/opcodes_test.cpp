// Tests of every opcode with every combination of special values, against the interpreter.

#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/testing/compare.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::Opcode;
using ir::Vec4;

/// Returns the specials, and values near the limits of angle and exponent functions.
std::vector<float> values() {
  std::vector<float> result(testing::kSpecials.begin(), testing::kSpecials.end());
  for (const float more : {3.14159265f, -1.5f, 0.3f, -0.75f, 10.25f, 127.5f, 128.0f, -126.0f,
                           -127.5f, 1000.0f, 0x1p31f, 0x1.8p-20f, 0.99999994f})
    result.push_back(more);
  return result;
}

/// Returns the allowed relative difference from the interpreter's result; 0 means to the bit.
float relativeTolerance(Opcode op) { return approximates(op) ? 0x1.2p-22f : 0; }

/// False if a result is always an operand, 0 or 1, or a negation of these.
bool rounds(Opcode op) {
  switch (op) {
  case Opcode::Abs:
  case Opcode::Cmp:
  case Opcode::Flr:
  case Opcode::Max:
  case Opcode::Min:
  case Opcode::Mov:
  case Opcode::Sge:
  case Opcode::Slt:
  case Opcode::Swz:
    return false;
  default:
    return true;
  }
}

/// Sines and cosines of larger angles are only checked to be in [-1, 1].
constexpr float kLargestAngle = 0x1p22f;

bool isAngle(Opcode op) { return op == Opcode::Cos || op == Opcode::Sin || op == Opcode::Scs; }

bool agree(Opcode op, float expected, float actual) {
  expected = ir::flushed(expected);
  actual = ir::flushed(actual);
  if (testing::sameBits(expected, actual))
    return true;
  if (!rounds(op) || !std::isfinite(expected) || std::isnan(actual))
    return false;
  // The processor detects underflow before rounding, the interpreter after. They may differ by the
  // least normal number. Near overflow one may be infinite.
  constexpr float kLeast = 0x1p-126f, kLargest = 0x1.fffffep127f;
  const float tolerance = relativeTolerance(op);
  const float bounded = std::isinf(actual) ? std::copysign(kLargest, actual) : actual;
  if (std::isinf(actual) && tolerance == 0)
    return false;
  return std::fabs(expected - bounded) <= tolerance * std::fabs(expected) + kLeast;
}

/// Returns the arithmetic opcodes. program_test.cpp tests the others: samples, KIL and ARL.
std::vector<int> arithmetic() {
  std::vector<int> opcodes;
  for (int i = 0; i < ir::kOpcodeCount; ++i)
    if (const ir::OpInfo &row = ir::info(Opcode(i));
        !row.has(ir::Texture) && !row.has(ir::Kills) && Opcode(i) != Opcode::Arl)
      opcodes.push_back(i);
  return opcodes;
}

class OpcodeTest : public ::testing::TestWithParam<std::tuple<int, Numerics>> {};

/// Tests all values in all operands. Components of a vector use different values from the list.
TEST_P(OpcodeTest, AgreesWithTheInterpreter) {
  const Opcode op = Opcode(std::get<0>(GetParam()));
  const Numerics numerics = std::get<1>(GetParam());
  const ir::OpInfo &row = ir::info(op);
  ir::Builder b(ir::Language::ArbVertex);
  const ir::Target result = b.result(ir::OutputKind::FrontPrimary);
  const std::array<ir::Source, 3> source = {b.attribute(ir::AttributeKind::Generic, 1),
                                            b.attribute(ir::AttributeKind::Generic, 2),
                                            b.attribute(ir::AttributeKind::Generic, 3)};
  const auto operand = [&](int i) {
    const ir::Source &whole = source[std::size_t(i)];
    return row.shapes[i] == 'S' ? whole.swz("x") : whole;
  };
  if (row.operandCount() == 1)
    b.op(op, result, {operand(0)});
  else if (row.operandCount() == 2)
    b.op(op, result, {operand(0), operand(1)});
  else
    b.op(op, result, {operand(0), operand(1), operand(2)});
  const ir::Program &program = b.program();

  const std::vector<float> all = values();
  const std::size_t n = all.size();
  std::vector<TestMachine::Attributes> lanes;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < (row.operandCount() > 1 ? n : 1); ++j)
      for (std::size_t k = 0; k < (row.operandCount() > 2 ? n : 1); ++k) {
        const auto vector = [&](std::size_t at, std::size_t step) {
          return Vec4{all[at], all[(at + step) % n], all[(at + 2 * step) % n],
                      all[(at + 3 * step) % n]};
        };
        TestMachine::Attributes lane = {vector(i, 1), vector(j, 5), vector(k, 7)};
        lane.resize(program.attributes.size());
        lanes.push_back(lane);
      }
  for (const std::string &cpu : testedCpus()) {
    const TestMachine machine(program, numerics, cpu);
    ASSERT_EQ(machine.reason(), "") << cpu;
    const auto results = machine.run(lanes, {});
    int wrong = 0;
    for (std::size_t i = 0; i < lanes.size() && wrong < 4; ++i) {
      ir::Inputs inputs;
      inputs.attributes = lanes[i];
      inputs.numerics = numerics;
      const Vec4 expected = ir::evaluate(program, inputs).outputs[0];
      for (std::size_t c = 0; c < 4; ++c) {
        const float actual = results[i].outputs[0][c];
        if (isAngle(op) && std::fabs(lanes[i][0][0]) > kLargestAngle &&
            std::isfinite(lanes[i][0][0])) {
          EXPECT_TRUE(std::fabs(actual) <= 1.0f) << row.name << " of " << lanes[i][0][0];
          continue;
        }
        if (!agree(op, expected[c], actual)) {
          ++wrong;
          ADD_FAILURE() << row.name << " on " << (cpu.empty() ? "this processor" : cpu)
                        << ", component " << c << ": " << actual << ", not " << expected[c]
                        << " of a=" << ::testing::PrintToString(lanes[i][0]) << " b="
                        << ::testing::PrintToString(lanes[i].size() > 1 ? lanes[i][1] : Vec4{})
                        << " c="
                        << ::testing::PrintToString(lanes[i].size() > 2 ? lanes[i][2] : Vec4{});
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, OpcodeTest,
                         ::testing::Combine(::testing::ValuesIn(arithmetic()),
                                            ::testing::Values(Numerics::Host, Numerics::Legacy)),
                         [](const auto &param) {
                           return std::string(ir::info(Opcode(std::get<0>(param.param))).name) +
                                  (std::get<1>(param.param) == Numerics::Host ? "Host" : "Legacy");
                         });

} // namespace
} // namespace arbiter::fp::llvm_back
