#include <limits>
#include <optional>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/testing/pass_check.h"
#include "fp_compiler/testing/nv_program.h"

namespace arbiter::fp::opt {
namespace {

using ir::Builder;
using ir::Opcode;

TEST(FoldConstants, ComputesWithSwizzleSignMaskAndSaturate) {
  Builder b;
  b.op(Opcode::Mad, b.color().mask("xz").sat(),
       {b.constant(1, 2, 3, 4).swz("wzyx"), b.constant(0.125f), -b.constant(0.25f)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(ir::print(program.code[0]), "MOV o0.xz, p3");
  EXPECT_EQ(program.parameters[3].constant, (ir::Vec4{0.25f, 0.25f, 0, 0.25f}));
}

TEST(FoldConstants, LooksOnlyAtWhatIsRead) {
  Builder b;
  const auto t = b.temporary();
  b.op(Opcode::Mov, t, {b.local(0)});
  b.op(Opcode::Dp3, b.color(), {b.constant(1, 2, 3, 4), t.read().swz("0111")});
  b.op(Opcode::Dph, b.color(), {b.constant(1, 2, 3, 4), t.read().swz("011x")});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(program.code[1].op, Opcode::Mov) << "DP3 does not read w";
  EXPECT_EQ(program.code[2].op, Opcode::Dph) << "DPH reads it";
}

TEST(FoldConstants, SharesRows) {
  Builder b;
  b.op(Opcode::Add, b.color().mask("x"), {b.constant(1), b.constant(2)});
  b.op(Opcode::Mul, b.color().mask("y"), {b.constant(1), b.constant(3)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program));
  EXPECT_EQ(program.parameters.size(), 4u) << "3 was there already";
}

TEST(FoldConstants, LeavesInfinityToTheHost) {
  Builder b;
  b.op(Opcode::Rcp, b.color(), {b.constant(0).swz("x")});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
}

TEST(FoldConstants, LeavesMovesAlone) {
  Builder b;
  b.op(Opcode::Mov, b.color(), {-b.constant(1, 2, 3, 4).swz("wzyx")});
  ir::Program program = b.take();
  EXPECT_FALSE(runChecked(foldConstants, program));
}

/// Returns the value that `op` of the constants folds to in a mode, or nothing if it does not fold.
std::optional<float> folded(Opcode op, std::initializer_list<float> values, Numerics numerics) {
  Builder b;
  ir::Source sources[3];
  std::size_t count = 0;
  for (const float value : values)
    sources[count++] = b.constant(value);
  if (count == 2)
    b.op(op, b.color(), {sources[0], sources[1]});
  else
    b.op(op, b.color(), {sources[0], sources[1], sources[2]});
  ir::Program program = b.take();
  if (!runChecked(foldConstants, program, "", numerics))
    return {};
  return program.parameters[program.code[0].src[0].index].constant[0];
}

TEST(FoldConstants, ComputesInTheMode) {
  // The constant truncates to 1 + 2^-16 on load, and its square loses 2^-32. In single precision
  // the result differs.
  constexpr float kJustAbove = 0x1.0001FEp0f;
  EXPECT_EQ(folded(Opcode::Mul, {kJustAbove, kJustAbove}, Numerics::Fp24), 0x1.0002p0f);
  EXPECT_EQ(folded(Opcode::Mul, {kJustAbove, kJustAbove}, Numerics::Host), kJustAbove * kJustAbove);
  // Each step is rounded: 2^17 + 1 gives 2^17.
  EXPECT_EQ(folded(Opcode::Mad, {1, 0x1p17f, 1}, Numerics::Fp24), 0x1p17f);
  EXPECT_EQ(folded(Opcode::Mad, {1, 0x1p17f, 1}, Numerics::Legacy), 0x1p17f + 1);
  // The result overflows 24-bit floats, but not singles.
  EXPECT_EQ(folded(Opcode::Mul, {0x1p40f, 0x1p40f}, Numerics::Fp24), std::nullopt);
  EXPECT_EQ(folded(Opcode::Mul, {0x1p-40f, 0x1p-40f}, Numerics::Fp24), 0.0f);
  EXPECT_EQ(folded(Opcode::Mul, {0x1p40f, 0x1p40f}, Numerics::Host), 0x1p80f);
}

TEST(FoldConstants, ZeroTimesInfinityIsAConstantInLegacy) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(folded(Opcode::Mul, {0, kInfinity}, Numerics::Host), std::nullopt);
  EXPECT_EQ(folded(Opcode::Mul, {0, kInfinity}, Numerics::Legacy), 0.0f);
  EXPECT_EQ(folded(Opcode::Mad, {0, kInfinity, 3}, Numerics::Fp24), 3.0f);
}

TEST(FoldConstants, AVertexProgramHasNo24Bits) {
  Builder b(ir::Language::ArbVertex);
  b.op(Opcode::Mul, b.result(ir::OutputKind::Position), {b.constant(0x1p40f), b.constant(0x1p40f)});
  ir::Program program = b.take();
  EXPECT_TRUE(runChecked(foldConstants, program, "", Numerics::Fp24));
}

TEST(FoldConstants, BitsAreCopiedAsTheyAre) {
  const std::string texts[] = {"MOV result.color, {1e-40, 1.0, 0.0, 0.0};",
                               "CMP result.color, {-1.0, 1.0, 1.0, 1.0}, {1e-40, 1.0, 0.0, 0.0}, "
                               "{-2e-40, -1e-41, 0.5, 1.0};"};
  for (const std::string &text : texts)
    for (const Numerics numerics : {Numerics::Host, Numerics::Legacy, Numerics::Fp24}) {
      ir::Program program = testing::nvFragmentProgram(text);
      (void)runChecked(foldConstants, program, text, numerics);
      const ir::Vec4 color =
          testing::outcome(program, {0, numerics}).results.at({ir::OutputKind::Color, 0});
      EXPECT_EQ(color[0] != 0.0f, numerics != Numerics::Fp24) << text;
    }
}

TEST(FoldConstants, RandomPrograms) { runOnRandomPrograms(foldConstants); }

} // namespace
} // namespace arbiter::fp::opt
