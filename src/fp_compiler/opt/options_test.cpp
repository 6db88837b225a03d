#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::opt {
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::FogMode;
using ir::Opcode;

/// Numbers for everything that a fragment reads. They depend on the binding only, so a program and
/// its lowered form read the same.
struct Fragment {
  explicit Fragment(std::uint64_t of) : seed(of) {}

  [[nodiscard]] ir::Vec4 made(std::size_t what) const {
    testing::Random random(seed * 64 + what);
    ir::Vec4 value = {};
    for (float &component : value)
      component =
          seed % 2 != 0 && random.chance(20)
              ? testing::kSpecials[std::size_t(random.below(int(testing::kSpecials.size())))]
              : random.real(-2, 2);
    return value;
  }
  [[nodiscard]] ir::Vec4 attribute(const ir::Attribute &of) const {
    ir::Vec4 value = made(std::size_t(of.kind) + 8u * of.index);
    if (of.kind == AttributeKind::FogCoord)
      value = {value[0], 0, 0, 1};
    return value;
  }

  [[nodiscard]] ir::Evaluation run(const ir::Program &program, Numerics numerics) const {
    std::vector<ir::Vec4> attributes;
    for (const ir::Attribute &each : program.attributes)
      attributes.push_back(attribute(each));
    ir::Inputs inputs;
    inputs.attributes = attributes;
    inputs.numerics = numerics;
    inputs.fogCoordinate = attribute({AttributeKind::FogCoord, 0})[0];
    inputs.secondary = attribute({AttributeKind::ColorSecondary, 0});
    inputs.parameter = [this](const ir::Parameter &row) {
      return made(row.kind == ir::ParameterKind::State ? std::size_t(row.state.item) : row.index);
    };
    inputs.texture = [](const ir::Sample &sample) { return sample.coordinate; };
    return ir::evaluate(program, inputs);
  }

  std::uint64_t seed;
};

bool same(const ir::Evaluation &a, const ir::Evaluation &b) {
  bool equal = a.killed == b.killed && a.outputs.size() == b.outputs.size();
  for (std::size_t o = 0; equal && o < a.outputs.size(); ++o)
    for (std::size_t c = 0; c < 4; ++c)
      equal &= testing::sameBits(a.outputs[o][c], b.outputs[o][c]);
  return equal;
}

/// The interpreter applies the options by itself, so it tells what their instructions must do.
TEST(LowerOptions, KeepsTheMeaningToTheBit) {
  int fogged = 0, summed = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    testing::RandomOptions options;
    options.wild = seed % 3 == 0;
    const ir::Program program = [&] {
      ir::Program made = testing::randomProgram(seed, options);
      made.options.fog = FogMode(seed % 4);
      made.options.colorSum = seed / 4 % 2 != 0;
      return made;
    }();
    ir::Program lowered = program;
    const bool has = program.options.fog != FogMode::None || program.options.colorSum;
    EXPECT_EQ(lowerOptions(lowered), has);
    EXPECT_EQ(lowered.options.fog, FogMode::None);
    EXPECT_FALSE(lowered.options.colorSum);
    for (const std::string &problem : ir::validate(lowered))
      ADD_FAILURE() << problem << "\n" << ir::print(lowered);
    for (const Numerics numerics : {Numerics::Host, Numerics::Legacy, Numerics::Fp24})
      for (std::uint64_t pixel = 0; pixel < 4; ++pixel) {
        const Fragment fragment(seed * 4 + pixel);
        ASSERT_TRUE(same(fragment.run(program, numerics), fragment.run(lowered, numerics)))
            << "seed " << seed << ", pixel " << pixel << "\n"
            << ir::print(program) << "lowered:\n"
            << ir::print(lowered);
      }
    fogged += program.options.fog != FogMode::None;
    summed += program.options.colorSum;
    EXPECT_FALSE(lowerOptions(lowered)) << "a second time";
  }
  EXPECT_GT(fogged, 0);
  EXPECT_GT(summed, 0);
}

Builder colored() {
  Builder b(ir::Language::AtiFragment);
  b.options().fog = FogMode::Linear;
  b.options().colorSum = true;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::ColorPrimary)});
  return b;
}

TEST(LowerOptions, SumsTheClampedColorBeforeTheFog) {
  ir::Program program = colored().take();
  EXPECT_TRUE(lowerOptions(program));
  EXPECT_EQ(ir::print(program), "a0 = fragment.color.primary\n"
                                "a1 = fragment.color.secondary\n"
                                "a2 = fragment.fogcoord\n"
                                "p0 = state.fog.factors\n"
                                "p1 = state.fog.color\n"
                                "t0 = temporary color\n"
                                "t1 = temporary fog\n"
                                "o0 = result.color[0]\n"
                                "  MOV t0, a0\n"
                                "  MOV_SAT t0.xyz, t0\n"
                                "  ADD t0.xyz, t0, a1\n"
                                "  MAD_SAT t1.x, a2.xxxx, p0.xxxx, p0.yyyy\n"
                                "  MOV_SAT t0, t0\n"
                                "  LRP t0.xyz, t1.xxxx, t0, p1\n"
                                "  MOV o0, t0\n");
}

TEST(LowerOptions, LeavesFogToATargetThatHasIt) {
  ir::Program program = colored().take();
  EXPECT_TRUE(lowerOptions(program, {.hasFog = true}));
  EXPECT_EQ(program.options.fog, FogMode::Linear);
  EXPECT_FALSE(program.options.colorSum);
  EXPECT_TRUE(program.parameters.empty());
  EXPECT_FALSE(lowerOptions(program, {.hasFog = true}));
}

TEST(LowerOptions, FogsByTheMagnitudeOfNegativeDistances) {
  for (const FogMode mode : {FogMode::Exp, FogMode::Exp2, FogMode::Linear}) {
    Builder b = colored();
    b.options().fog = mode;
    const Fragment fragment(3);
    ir::Program program = b.take(), magnitude = program;
    (void)lowerOptions(program);
    (void)lowerOptions(magnitude, {.hasNegativeFogDistances = true});
    EXPECT_EQ(magnitude.code.size(), program.code.size() + 1);
    EXPECT_TRUE(ir::validate(magnitude).empty());
    EXPECT_NE(ir::print(magnitude).find("ABS t1.x, a2.xxxx"), std::string::npos)
        << ir::print(magnitude);
  }
}

TEST(LowerOptions, AddsNothingToAProgramWithoutThem) {
  Builder b;
  b.op(Opcode::Mov, b.color(), {b.attribute(AttributeKind::ColorPrimary)});
  ir::Program program = b.take();
  EXPECT_FALSE(lowerOptions(program));
  EXPECT_EQ(program.code.size(), 1u);
  EXPECT_TRUE(program.temporaries.empty());
}

} // namespace
} // namespace arbiter::fp::opt
