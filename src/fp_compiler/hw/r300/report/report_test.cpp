#include "fp_compiler/hw/r300/report/report.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "fp_compiler/hw/cycles.h"
#include "fp_compiler/hw/r300/check/sample_code.h"
#include "fp_compiler/hw/r300/report/wording.h"

namespace arbiter::fp::hw::r300 {
namespace {

using testing::sampleCode;
using testing::sampleProgram;

NativeReport sampleReport() {
  NativeReport result;
  report(result, sampleProgram(), sampleCode());
  return result;
}

const Reason *find(const NativeReport &report, std::string_view text) {
  for (const Reason &reason : report.reasons)
    if (reason.text == text)
      return &reason;
  return nullptr;
}

TEST(R300Report, CountsAreThoseOfTheCode) {
  EXPECT_EQ(counts(sampleCode()), (ResourceCounts{7, 4, 3, 2, 4, 1, 2}));
  EXPECT_EQ(counts(Code{}).texIndirections, 1u);
}

TEST(R300Report, NodesSayWhatTheyWaitFor) {
  const NativeReport result = sampleReport();
  ASSERT_EQ(result.nodes.size(), 2u);
  EXPECT_EQ(result.nodes[0].reason, "");
  EXPECT_EQ(result.nodes[0].textures, std::vector<std::uint32_t>{0});
  EXPECT_EQ(result.nodes[0].pairs, 1u);
  EXPECT_EQ(result.nodes[1].reason, "TEX reads a, which ADD wrote in node 1");
  EXPECT_EQ(result.nodes[1].textures, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(result.nodes[1].pairs, 3u);
}

TEST(R300Report, HalvesOfASharedPairCostHalfASlotEach) {
  const NativeReport result = sampleReport();
  ASSERT_EQ(result.costs.size(), 7u);
  EXPECT_EQ(result.costs[1].slots, 1);
  EXPECT_EQ(result.costs[5].slots, 0.5);
  EXPECT_EQ(result.costs[6].slots, 1.5);
  EXPECT_EQ(result.costs[0].textures, 1u);
  EXPECT_EQ(result.costs[2].node, 1u);
  for (const InstructionCost &cost : result.costs)
    EXPECT_FALSE(cost.gone);
  Code shorter = sampleCode();
  shorter.pairs[2].alpha = {};
  NativeReport without;
  report(without, sampleProgram(), shorter);
  EXPECT_TRUE(without.costs[5].gone);
}

TEST(R300Report, Reasons) {
  const NativeReport result = sampleReport();
  const Reason *apart = find(result, "RGB and alpha of LRP are in different slots");
  ASSERT_NE(apart, nullptr);
  EXPECT_EQ(apart->resource, &ResourceCounts::aluInstructions);
  EXPECT_EQ(apart->amount, 1u) << "one slot and a half, less the half that makes the others whole";
  EXPECT_EQ(apart->instructions, std::vector<std::uint32_t>{6});
  const Reason *single = find(result, "instructions of one slot");
  ASSERT_NE(single, nullptr);
  EXPECT_EQ(single->amount, 3u);
  EXPECT_EQ(single->instructions, (std::vector<std::uint32_t>{1, 4, 5}));
  EXPECT_NE(find(result, "KIL is a texture instruction"), nullptr);
  EXPECT_NE(find(result, "fragment.texcoord[0] is interpolated"), nullptr);
  const Reason *arrive = find(result, "interpolants arrive in temporaries");
  ASSERT_NE(arrive, nullptr);
  EXPECT_EQ(arrive->amount, 2u);
  EXPECT_EQ(find(result, "values that are live at once")->amount, 2u);
}

TEST(R300Report, MoreThanEightInterpolatorsAreSaid) {
  Code code = sampleCode();
  code.interpolators = 9;
  NativeReport result;
  report(result, sampleProgram(), code);
  EXPECT_NE(find(result, "position and fog take a texture coordinate's interpolator each: 9 of 8 "
                         "are needed"),
            nullptr);
}

ir::Instruction move(const ir::Source &source, std::uint8_t mask = 15) {
  ir::Instruction instruction;
  instruction.op = ir::Opcode::Mov;
  instruction.dst.mask = mask;
  instruction.src[0] = source;
  return instruction;
}

// Native swizzles follow the table in machine.h. Components that do not matter match anything, and
// alpha takes any component.
TEST(R300Wording, NativeSwizzles) {
  ir::Builder b;
  const ir::Source r = b.temporary().read();
  for (const char *native :
       {"xyzw", "xxxy", "yyyx", "zzzw", "wwwx", "yzxw", "zxyy", "wzyx", "0000", "111w", "xyz1"})
    EXPECT_TRUE(isNative(move(r.swz(native)), 0)) << native;
  for (const char *other : {"xzyw", "yxzw", "zyxw", "xyxw", "xyww", "wwzx", "xy01"})
    EXPECT_FALSE(isNative(move(r.swz(other)), 0)) << other;
  EXPECT_TRUE(isNative(move(r.swz("yxzw"), 4), 0)) << "z alone";
  EXPECT_TRUE(isNative(move(r.swz("yxzw"), 8), 0)) << "alpha alone";
  EXPECT_TRUE(isNative(move(r.negated(8)), 0)) << "alpha has its own sign";
  EXPECT_FALSE(isNative(move(r.negated(1)), 0));
  EXPECT_TRUE(isNative(move(r.negated(7)), 0));
  EXPECT_TRUE(isNative(move(r.negated(1), 9), 0)) << "y and z are not used";
}

TEST(R300Wording, WhyASlotIsThere) {
  ir::Builder b;
  const ir::Target r = b.temporary("R0");
  b.op(ir::Opcode::Sin, r, {r.read().swz("x")});
  b.op(ir::Opcode::Add, r, {r.read(), r.read().swz("yxz0")});
  b.op(ir::Opcode::Mul, r.mask("xyz"), {r.read().negated(1), r.read()});
  b.tex(ir::Opcode::Tex, r, r.read().swz("yxzw"), 0, ir::TexTarget::Tex2D);
  b.tex(ir::Opcode::Txp, r.mask("x"), -b.constant(1, 2, 3, 4), 0, ir::TexTarget::Tex2D);
  b.tex(ir::Opcode::Tex, r.sat(), -r.read(), 0, ir::TexTarget::Tex2D);
  const ir::Program program = b.take();
  const auto text = [&](std::uint16_t origin, Cause cause, Extent extent = Extent::OneSlot) {
    return aluText(program, origin, cause, extent);
  };
  EXPECT_EQ(text(0, Cause::Instruction, Extent::Expansion), "SIN is a polynomial");
  EXPECT_EQ(text(0, Cause::Instruction), "instructions of one slot");
  EXPECT_EQ(text(1, Cause::Swizzle), "swizzle .y,x,z,0 is not native");
  EXPECT_EQ(text(2, Cause::Swizzle), "swizzle .-x,y,z is not native");
  EXPECT_EQ(text(3, Cause::TextureOperand), "coordinate of TEX is swizzled: a move");
  EXPECT_EQ(text(4, Cause::TextureOperand), "coordinate of TXP is a constant: a move");
  EXPECT_EQ(text(5, Cause::TextureOperand), "coordinate of TEX is negated: a move");
  EXPECT_EQ(text(4, Cause::TextureResult), "result of TXP is under a write mask");
  EXPECT_EQ(text(5, Cause::TextureResult), "result of TEX is saturated");
  EXPECT_EQ(text(kNone, Cause::EmptyNode), "a node without arithmetic needs an empty slot");
  Constant own;
  own.origin = 0;
  EXPECT_EQ(constantText(program, own), "a constant of the driver's own for SIN");
}

TEST(R300Cycles, PairsAndSamplesRunSideBySide) {
  const CycleEstimate estimate = estimateR300(sampleCode());
  EXPECT_EQ(estimate.cycles, 4);
  EXPECT_EQ(estimate.bound, "ALU");
  ASSERT_EQ(estimate.units.size(), 2u);
  EXPECT_EQ(estimate.units[1].name, "texture");
  EXPECT_EQ(estimate.units[1].cycles, 3);
}

} // namespace
} // namespace arbiter::fp::hw::r300
