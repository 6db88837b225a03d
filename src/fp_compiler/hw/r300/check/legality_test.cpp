#include "fp_compiler/hw/r300/check/legality.h"

#include <gtest/gtest.h>
#include <set>

#include "fp_compiler/hw/r300/check/sample_code.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp::hw::r300 {
namespace {

using namespace testing;

std::string listing(const std::vector<Fault> &faults) {
  std::string text;
  for (const Fault &fault : faults)
    text += fault.text + "\n";
  return text;
}

TEST(Legality, TheSampleIsLegal) {
  EXPECT_TRUE(ir::validate(sampleProgram()).empty());
  EXPECT_EQ(listing(faults(sampleCode(), sampleProgram())), "");
  EXPECT_TRUE(overflows(sampleCode()).empty());
}

/// A change to the sample, the rule that it breaks, and what the message contains.
struct Mutation {
  Rule rule;
  const char *says;
  void (*change)(Code &);
};

const Mutation kMutations[] = {
    {Rule::NoNode, "no node",
     [](Code &c) {
       c.nodes.clear();
       c.pairs.clear();
       c.textures.clear();
     }},
    {Rule::EmptyNode, "node 0: no pair",
     [](Code &c) {
       c.nodes[0].pairs = 0;
       c.nodes[1].firstPair = 0;
     }},
    {Rule::NodeWithoutTexture, "node 1: no TEX",
     [](Code &c) {
       c.nodes[0].textures = 3;
       c.nodes[1].firstTexture = 3;
       c.nodes[1].textures = 0;
     }},
    {Rule::NodeBlocks, "node 1: starts at TEX 1 and pair 2",
     [](Code &c) { c.nodes[1].firstPair = 2; }},
    {Rule::NodeBlocks, "the nodes end after", [](Code &c) { c.nodes[1].pairs = 2; }},
    {Rule::NodeBlocks, "node 1: starts", [](Code &c) { c.nodes[1].textures = 3; }},
    {Rule::SourceNumber, "pair 0, RGB, argument A: source 4",
     [](Code &c) { c.pairs[0].rgb.arguments[0].source = 4; }},
    {Rule::SourceAddress, "pair 0, RGB, argument C: RGB source 2 has no address",
     [](Code &c) { c.pairs[0].rgb.arguments[2].source = 2; }},
    {Rule::SourceAddress, "pair 0, alpha, argument A: alpha source 2",
     [](Code &c) { c.pairs[0].alpha.arguments[0].source = 2; }},
    // W of an RGB argument needs an alpha address, and X of an alpha argument needs an RGB address.
    {Rule::SourceAddress, "pair 2, RGB, argument C: alpha source 0",
     [](Code &c) { c.pairs[2].rgb.arguments[2].select = RgbSelect::Www; }},
    {Rule::SourceAddress, "pair 2, RGB, argument C: alpha source 0",
     [](Code &c) { c.pairs[2].rgb.arguments[2].select = RgbSelect::Wzy; }},
    {Rule::SourceAddress, "pair 3, alpha, argument B: RGB source 0",
     [](Code &c) { c.pairs[3].rgb.sources[0] = {}; }},
    {Rule::SourceIndex, "pair 0, alpha: source 1: no constant c1",
     [](Code &c) { c.pairs[0].alpha.sources[1].index = 1; }},
    {Rule::SourceIndex, "pair 0, RGB: source 2: no register r4",
     [](Code &c) { c.pairs[0].rgb.sources[2] = reg(4); }},
    {Rule::Presubtract, "pair 2, RGB, argument A: the RGB half makes no",
     [](Code &c) { c.pairs[2].rgb.presubtract = Presubtract::None; }},
    {Rule::Presubtract, "pair 3, alpha, argument A: the alpha presubtract lacks",
     [](Code &c) { c.pairs[3].alpha.sources[1] = {}; }},
    // The alpha half cannot use the RGB half's presubtract result.
    {Rule::Presubtract, "pair 3, alpha, argument A: the RGB half makes no",
     [](Code &c) { c.pairs[3].alpha.arguments[0].select = AlphaSelect::X; }},
    {Rule::PresubtractSelect, "pair 2, RGB, argument A",
     [](Code &c) { c.pairs[2].rgb.arguments[0].select = RgbSelect::Yzx; }},
    {Rule::PresubtractSelect, "pair 2, RGB, argument A",
     [](Code &c) { c.pairs[2].rgb.arguments[0].select = RgbSelect::Zxy; }},
    {Rule::DotProduct, "pair 3: Dp beside no dot",
     [](Code &c) { c.pairs[3].alpha.op = AlphaOp::Dp; }},
    {Rule::DotProduct, "pair 1: Dp4 without Dp",
     [](Code &c) { c.pairs[1].alpha.op = AlphaOp::Min; }},
    {Rule::ReplicatedAlpha, "pair 0: ReplAlpha",
     [](Code &c) {
       c.pairs[0].rgb.op = RgbOp::ReplAlpha;
       c.pairs[0].alpha = {};
     }},
    {Rule::Mask, "pair 0, RGB", [](Code &c) { c.pairs[0].rgb.mask = 15; }},
    {Rule::Mask, "pair 3, alpha", [](Code &c) { c.pairs[3].alpha.outputMask = 12; }},
    {Rule::IdleWrite, "pair 3, RGB", [](Code &c) { c.pairs[3].rgb.outputMask = 1; }},
    {Rule::IdleWrite, "pair 2, alpha", [](Code &c) { c.pairs[2].alpha.op = AlphaOp::None; }},
    {Rule::Destination, "pair 0, RGB: writes no register",
     [](Code &c) { c.pairs[0].rgb.temporary = kNone; }},
    {Rule::Destination, "pair 1, alpha: no register r9",
     [](Code &c) { c.pairs[1].alpha.temporary = 9; }},
    {Rule::Destination, "interpolant 1: no register r7",
     [](Code &c) { c.interpolants[1].temporary = 7; }},
    {Rule::Target, "pair 2, RGB: no colour target 4", [](Code &c) { c.pairs[2].rgb.output = 4; }},
    {Rule::Depth, "pair 2, RGB: writes depth", [](Code &c) { c.pairs[2].rgb.depth = true; }},
    {Rule::TextureRegister, "node 0, TEX 0: no register r8",
     [](Code &c) { c.textures[0].source = 8; }},
    {Rule::TextureRegister, "TEX 0: no destination",
     [](Code &c) { c.textures[0].destination = kNone; }},
    {Rule::TextureRegister, "TEX 1: a kill with", [](Code &c) { c.textures[1].destination = 3; }},
    {Rule::TextureUnit, "TEX 2: no image unit 16", [](Code &c) { c.textures[2].unit = 16; }},
    {Rule::TextureHazard, "TEX 2: reads r2",
     [](Code &c) {
       c.textures[1] = c.textures[2];
       c.textures[2].source = 2;
       c.textures[2].destination = 0;
     }},
    {Rule::TextureHazard, "TEX 2: writes r2",
     [](Code &c) { c.textures[1] = {TexOp::Load, 3, ir::TexTarget::Tex2D, 0, 2, 0}; }},
    {Rule::Interpolants, "interpolant 1: r0 holds",
     [](Code &c) { c.interpolants[1].temporary = 0; }},
    {Rule::Interpolants, "interpolant 0: twice", [](Code &c) { c.interpolants[1].attribute = 0; }},
    // A register is readable once an interpolant, a sample or the result of a half has written it.
    {Rule::Unwritten, "pair 2, RGB, argument A: reads r3.x",
     [](Code &c) { c.interpolants.pop_back(); }},
    {Rule::Unwritten, "pair 3, alpha, argument A: reads r3.w",
     [](Code &c) { c.interpolants.pop_back(); }},
    {Rule::Unwritten, "node 1, TEX 2: reads r3.xy",
     [](Code &c) {
       c.interpolants.pop_back();
       c.textures[2].source = 3;
     }},
    {Rule::Unwritten, "pair 1, RGB, argument A: reads r2.z",
     [](Code &c) { c.textures[2].destination = 3; }},
    {Rule::Unwritten, "node 1, TEX 2: reads r1.y",
     [](Code &c) {
       c.textures[0].destination = 2;
       for (Source &source : c.pairs[0].rgb.sources)
         source.index = 0;
       c.pairs[0].rgb.mask = 1;
     }},
    {Rule::Registers, "5 registers are claimed, 4 are used", [](Code &c) { c.temporaries = 5; }},
    {Rule::Registers, "3 registers are claimed, 4 are used", [](Code &c) { c.temporaries = 3; }},
    {Rule::Reference, "pair 0, RGB", [](Code &c) { c.pairs[0].rgb.origin = 7; }},
    {Rule::Reference, "pair 0, alpha", [](Code &c) { c.pairs[0].alpha.origin = kNone; }},
    {Rule::Reference, "TEX 2: its origin is another", [](Code &c) { c.textures[2].origin = 1; }},
    {Rule::Reference, "TEX 0: its origin is another", [](Code &c) { c.textures[0].unit = 1; }},
    {Rule::Reference, "constant 0", [](Code &c) { c.constants[0].index = 2; }},
    {Rule::Reference, "interpolant 2: the program has",
     [](Code &c) { c.interpolants[1].attribute = 2; }},
    {Rule::Reference, "pair 3, alpha: the program has no result.color[1]",
     [](Code &c) { c.pairs[3].alpha.output = 1; }},
    {Rule::Interpolators, "2 interpolators are claimed, 1 are used",
     [](Code &c) { c.interpolators = 2; }},
    {Rule::Interpolators, "1 interpolators are claimed, 2 are used",
     [](Code &c) {
       c.interpolants.push_back({kFogCoordinate, 2});
     }},
};

TEST(Legality, EachRuleTells) {
  const ir::Program program = sampleProgram();
  std::set<Rule> seen;
  for (const Mutation &mutation : kMutations) {
    Code code = sampleCode();
    mutation.change(code);
    const std::vector<Fault> found = faults(code, program);
    bool listed = false;
    for (const Fault &fault : found)
      listed |= fault.rule == mutation.rule && fault.text.find(mutation.says) != std::string::npos;
    EXPECT_TRUE(listed) << mutation.says << " is not among:\n" << listing(found);
    seen.insert(mutation.rule);
  }
  EXPECT_EQ(int(seen.size()), kRuleCount) << "a rule without a test";
}

// Each change is at the border of a rule, on its legal side.
const Mutation kLegal[] = {
    {Rule::SourceAddress, "Wzy reads no W where x is not written",
     [](Code &c) {
       c.pairs[2].rgb.arguments[2].select = RgbSelect::Wzy;
       c.pairs[2].rgb.outputMask = 6;
     }},
    {Rule::SourceAddress, "a constant select needs no address",
     [](Code &c) { c.pairs[0].rgb.arguments[1].source = 2; }},
    {Rule::Presubtract, "one operand needs one address",
     [](Code &c) {
       c.pairs[3].alpha.sources[1] = {};
       c.pairs[3].alpha.presubtract = Presubtract::OneMinusS0;
     }},
    {Rule::DotProduct, "Dp3 beside Dp, whose arguments do not count",
     [](Code &c) {
       c.pairs[1].rgb.op = RgbOp::Dp3;
       c.pairs[1].alpha.arguments[0].source = 2;
     }},
    {Rule::ReplicatedAlpha, "ReplAlpha beside any operation",
     [](Code &c) { c.pairs[0].rgb.op = RgbOp::ReplAlpha; }},
    {Rule::Destination, "a register and a target at once",
     [](Code &c) {
       c.pairs[2].rgb.temporary = 3;
       c.pairs[2].rgb.mask = 7;
     }},
    {Rule::TextureHazard, "a sample into its own coordinate",
     [](Code &c) {
       c.textures[2].destination = 1;
       c.pairs[1].rgb.sources[0] = c.pairs[1].alpha.sources[0] = reg(1);
     }},
    {Rule::Unwritten, "a component that a mask leaves out",
     [](Code &c) {
       c.interpolants.pop_back();
       c.pairs[2].rgb = {};
       c.pairs[2].rgb.sources[2] = reg(2);
       c.pairs[3].alpha.presubtract = Presubtract::OneMinusS0;
     }},
    {Rule::NodeWithoutTexture, "a first node of arithmetic",
     [](Code &c) {
       c.textures.erase(c.textures.begin());
       c.nodes[0].textures = 0;
       c.nodes[1].firstTexture = 0;
       c.pairs[0].rgb.sources[0] = c.pairs[0].alpha.sources[0] = reg(0);
     }},
};

TEST(Legality, WhatIsAllowedIsNoFault) {
  for (const Mutation &legal : kLegal) {
    Code code = sampleCode();
    legal.change(code);
    EXPECT_EQ(listing(faults(code, sampleProgram())), "") << legal.says;
  }
}

TEST(Legality, SizesAreNoFaultButAnOverflow) {
  Code code = sampleCode();
  code.pairs.resize(65);
  code.nodes[1].pairs = 64;
  code.constants.resize(33);
  EXPECT_EQ(listing(faults(code)), "");
  EXPECT_EQ(overflows(code), (std::vector<std::string>{"65 pairs of 64", "33 constants of 32"}));
  const Chip small = {.pairs = 80,
                      .textures = 2,
                      .nodes = 1,
                      .temporaries = 3,
                      .constants = 40,
                      .interpolators = 0};
  EXPECT_EQ(overflows(code, small),
            (std::vector<std::string>{"3 TEX of 2", "2 nodes of 1", "4 registers of 3",
                                      "1 interpolators of 0"}));
}

} // namespace
} // namespace arbiter::fp::hw::r300
