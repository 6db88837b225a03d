#include "fp_compiler/hw/r300/compile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/hw/r300/check/legality.h"
#include "fp_compiler/hw/r300/execute/execute.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::hw::r300 {
namespace {

void expectLegal(const ir::Program &program, const CompileOptions &options, std::uint64_t seed) {
  const Code code = compile(program, options);
  for (const Fault &fault : faults(code, program))
    ADD_FAILURE() << "seed " << seed << ": " << fault.text << "\n" << ir::print(program);
}

/// Returns the slots of one instruction alone, as the peer compiles it.
int slotsOf(ir::Opcode op) {
  switch (op) {
  case ir::Opcode::Flr:
  case ir::Opcode::Lrp:
  case ir::Opcode::Sge:
  case ir::Opcode::Slt:
  case ir::Opcode::Xpd:
    return 2;
  case ir::Opcode::Pow:
    return 3;
  case ir::Opcode::Dst:
    return 5;
  case ir::Opcode::Cos:
  case ir::Opcode::Sin:
    return 7;
  case ir::Opcode::Lit:
    return 9;
  case ir::Opcode::Scs:
    return 12;
  default:
    return 1;
  }
}

/// Returns how many copies bring an operand into a form that the unit has.
int copiesOf(const ir::Operand &operand, std::uint8_t used) {
  constexpr int kNative[][3] = {{0, 1, 2}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3},
                                {1, 2, 0}, {2, 0, 1}, {3, 2, 1}, {4, 4, 4}, {5, 5, 5}};
  const auto native = [&](int components) {
    for (const auto &select : kNative) {
      bool fits = true;
      int signs = 0, count = 0;
      for (int c = 0; c < 3; ++c)
        if (components >> c & 1) {
          fits &= int(operand.swizzle[std::size_t(c)]) == select[c];
          signs += operand.negate >> c & 1;
          ++count;
        }
      if (fits && (signs == 0 || signs == count))
        return true;
    }
    return false;
  };
  const int rgb = used & 7;
  if (native(rgb))
    return 0;
  for (const int two : {3, 5, 6})
    if (native(rgb & two) && native(rgb & ~two))
      return 2;
  return 3;
}

/// Returns the pairs of a translation that compiles every instruction alone.
int naivePairs(const ir::Program &program, const CompileOptions &options) {
  int pairs = 1; // an empty node has one
  for (const ir::Instruction &instruction : program.code) {
    const ir::OpInfo &row = ir::info(instruction.op);
    for (int i = 0; i < row.operandCount(); ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      const std::uint8_t used = ir::operandMask(instruction, i);
      pairs += copiesOf(operand, used);
      const bool plain = operand.file != ir::File::Parameter && operand.negate == 0 &&
                         operand.swizzle == ir::kIdentity;
      if ((row.has(ir::Texture) || row.has(ir::Kills)) && !plain)
        pairs += copiesOf(operand, used) ? 0 : 1;
    }
    if (row.has(ir::Kills) || row.has(ir::Texture))
      ++pairs; // an ALU slot for the node
    else
      pairs += slotsOf(instruction.op);
    if (!row.has(ir::Texture))
      continue;
    pairs += instruction.dst.saturate || instruction.dst.file == ir::File::Output ||
             instruction.dst.mask != 15;
    pairs += ir::isShadow(instruction.target) ? 5 : 0;
    pairs += options.scaleRectangles;
  }
  for (const ir::Attribute &attribute : program.attributes)
    pairs += attribute.kind == ir::AttributeKind::Position ? 3 : 0;
  if (program.options.fog != ir::FogMode::None)
    pairs += 4 + 3 * int(program.outputs.size());
  if (program.options.colorSum)
    pairs += 2 * int(program.outputs.size());
  return pairs;
}

TEST(R300Compile, NeverTakesMoreThanEachInstructionByItself) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    fp::testing::RandomOptions options;
    options.wild = seed % 2 == 0;
    options.maxInstructions = seed % 5 == 0 ? 60 : 16;
    const ir::Program program = fp::testing::randomProgram(seed, options);
    const CompileOptions compileOptions = {seed % 4 < 2};
    EXPECT_LE(int(compile(program, compileOptions).pairs.size()),
              naivePairs(program, compileOptions))
        << "seed " << seed << "\n"
        << ir::print(program);
  }
}

TEST(R300Compile, RandomProgramsAreLegal) {
  for (std::uint64_t seed = 0; seed < 500 && !HasFailure(); ++seed) {
    fp::testing::RandomOptions options;
    options.wild = seed % 2 == 0;
    options.maxInstructions = seed % 5 == 0 ? 60 : 16;
    expectLegal(fp::testing::randomProgram(seed, options), {seed % 4 < 2}, seed);
  }
}

TEST(R300Compile, AtiShadersAreLegal) {
  for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
    ir::Program program = ati::lower(fp::testing::randomAtiShader(seed), {});
    program.options.colorSum = seed % 2 == 0;
    program.options.fog = ir::FogMode(seed / 2 % 4);
    expectLegal(program, {}, seed);
  }
}

TEST(R300Compile, SinesStayWithinTheirError) {
  ir::Builder builder;
  const ir::Source angle = builder.attribute(ir::AttributeKind::TexCoord, 0).swz("x");
  const ir::Target both = builder.temporary();
  builder.op(ir::Opcode::Scs, both.mask("xy"), {angle});
  builder.op(ir::Opcode::Mov, builder.color().mask("xy"), {both.read()});
  builder.op(ir::Opcode::Sin, builder.color().mask("z"), {angle});
  builder.op(ir::Opcode::Cos, builder.color().mask("w"), {angle});
  const ir::Program &program = builder.program();
  const Code code = compile(program, {});
  double worst = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const float x = float(i) * 0.00390625f;
    const std::array<ir::Vec4, 1> attributes = {ir::Vec4{x, 0, 0, 1}};
    ir::Inputs inputs;
    inputs.attributes = attributes;
    const ir::Vec4 result = execute(code, program, inputs).outputs[0];
    for (const double error : {result[0] - std::cos(double(x)), result[1] - std::sin(double(x)),
                               result[2] - std::sin(double(x)), result[3] - std::cos(double(x))})
      worst = std::max(worst, std::fabs(error));
  }
  EXPECT_LT(worst, 0x1p-9);
  EXPECT_GT(worst, 0x1p-12) << "it is a parabola, and the document says so";
}

// Compile time must not grow with the square of the length: 20,000 statements take a quarter of a
// second.
TEST(R300Compile, LongProgramsAreCompiledWhole) {
  constexpr int kStatements = 20000;
  ir::Builder builder;
  const ir::Source coordinate = builder.attribute(ir::AttributeKind::TexCoord, 0);
  const ir::Target sum = builder.temporary();
  builder.op(ir::Opcode::Mov, sum, {coordinate});
  for (int i = 0; i < kStatements; ++i)
    builder.op(ir::Opcode::Max, sum, {sum.read(), coordinate.swz("yzxw")});
  builder.op(ir::Opcode::Mov, builder.color(), {sum.read()});
  const Code code = compile(builder.program(), {});
  EXPECT_EQ(code.pairs.size(), std::size_t(kStatements));
  EXPECT_EQ(code.nodes.size(), 1u);
}

TEST(R300Compile, AnEmptyProgramIsOneNodeWithOneIdlePair) {
  const Code code = compile({}, {});
  ASSERT_EQ(code.nodes.size(), 1u);
  ASSERT_EQ(code.pairs.size(), 1u);
  EXPECT_EQ(code.pairs[0].rgb.cause, Cause::EmptyNode);
  EXPECT_TRUE(faults(code).empty());
}

} // namespace
} // namespace arbiter::fp::hw::r300
