/// Tests of the numerics modes in the emitted GLSL: where guards occur, and that the interpreter's
/// results stay within the analysed ranges. tests/back_ends_vs_interpreter checks the values that
/// the text computes.
#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/glsl/glsl.h"
#include "fp_compiler/back/glsl/validator.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::glsl {

using analysis::RangeAnalysis;
using analysis::ValueRange;
namespace {

using ir::AttributeKind;
using ir::Builder;
using ir::Opcode;

std::string textOf(const Builder &builder, Numerics numerics) {
  return emitGlsl(builder.program(), {}, numerics).text;
}

/// Returns the text after the declarations and helper functions.
std::string bodyOf(const Builder &builder, Numerics numerics) {
  const std::string text = textOf(builder, numerics);
  return text.substr(text.find("void main()"));
}

TEST(Legacy, AGuardStandsWhereAZeroMayMeetAnInfinity) {
  Builder b;
  b.op(Opcode::Mul, b.color(), {b.attribute(AttributeKind::TexCoord, 0), b.local(0)});
  EXPECT_TRUE(contains(bodyOf(b, Numerics::Legacy), "arb_mul(gl_TexCoord[0], arb_param[0])"));
  EXPECT_TRUE(contains(bodyOf(b, Numerics::Host), "gl_TexCoord[0] * arb_param[0]"));
  EXPECT_FALSE(contains(textOf(b, Numerics::Host), "arb_mul"));
  EXPECT_TRUE(validates(textOf(b, Numerics::Legacy)));
}

TEST(Legacy, WhatIsProvedFiniteNeedsNone) {
  Builder b;
  const auto t = b.temporary(), u = b.temporary();
  const auto color = b.attribute(AttributeKind::ColorPrimary);
  b.op(Opcode::Mul, t, {color, b.constant(0, 1, 2, 0.5f)});
  b.op(Opcode::Mad, u.sat(), {b.attribute(AttributeKind::TexCoord, 0), b.constant(2), t.read()});
  b.op(Opcode::Lrp, t, {color, u.read(), b.constant(0, 1, 2, 3)});
  b.op(Opcode::Xpd, u.mask("xyz"), {t.read(), color});
  b.op(Opcode::Dp4, t.mask("x"), {t.read(), color});
  b.op(Opcode::Dst, t.mask("yw"), {u.read(), color});
  b.op(Opcode::Dph, b.color(), {t.read(), u.read()});
  EXPECT_EQ(textOf(b, Numerics::Legacy), textOf(b, Numerics::Host));
}

TEST(Legacy, OnlyTheFactorThatMayBeZeroIsLookedAt) {
  Builder b;
  const auto unknown = b.attribute(AttributeKind::TexCoord, 0);
  b.op(Opcode::Mul, b.color().mask("xy"), {unknown, b.constant(0.5f, -2, 0, 0)});
  b.op(Opcode::Mul, b.color().mask("zw"), {unknown, b.constant(0.5f, -2, 0, 1)});
  const std::string body = bodyOf(b, Numerics::Legacy);
  EXPECT_TRUE(contains(body, ".xy = gl_TexCoord[0].xy * vec2(0.5, -2.0)")) << body;
  EXPECT_TRUE(contains(body, ".zw = arb_mulz(vec2(0.0, 1.0), gl_TexCoord[0].zw)")) << body;
}

TEST(Legacy, ADivisionCanTellTheSignOfAZero) {
  for (const bool divides : {false, true}) {
    Builder b;
    const auto t = b.temporary();
    b.op(Opcode::Mul, t, {b.attribute(AttributeKind::TexCoord, 0), b.local(0)});
    if (divides)
      b.op(Opcode::Rcp, t, {t.read().swz("x")});
    b.op(Opcode::Mov, b.color(), {t.read()});
    EXPECT_EQ(contains(textOf(b, Numerics::Legacy), "p != p"), divides);
  }
}

TEST(Fp24, RoundsWhatIsReadAndEachStep) {
  Builder b;
  b.op(Opcode::Mad, b.color(),
       {b.attribute(AttributeKind::ColorPrimary), b.constant(0.1f), b.local(0)});
  const std::string body = bodyOf(b, Numerics::Fp24);
  EXPECT_TRUE(contains(body, "= arb_colour(gl_Color);")) << body;
  EXPECT_TRUE(contains(body, "= arb_truncate(arb_param[0]);")) << body;
  EXPECT_TRUE(contains(body, "arb_round(arb_round(i0 * vec4(0.09999943)) + ")) << body;
}

TEST(Fp24, WithoutItsExtensionsAndForVerticesItIsLegacy) {
  Builder b;
  b.op(Opcode::Mul, b.color(), {b.attribute(AttributeKind::TexCoord, 0), b.local(0)});
  GlslHost old;
  old.bitEncoding = false;
  EXPECT_EQ(numericsOn(old, Numerics::Fp24), Numerics::Legacy);
  EXPECT_EQ(numericsOn({}, Numerics::Fp24), Numerics::Fp24);
  EXPECT_EQ(emitGlsl(b.program(), old, Numerics::Fp24).text, textOf(b, Numerics::Legacy));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ir::Program vertex = testing::randomVertexProgram(seed);
    EXPECT_EQ(emitGlsl(vertex, {}, Numerics::Fp24).text,
              emitGlsl(vertex, {}, Numerics::Legacy).text);
  }
}

TEST(Legacy, EveryTextIsAShader) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    EXPECT_TRUE(validates(emitGlsl(testing::randomProgram(seed, {.wild = true, .options = false}),
                                   {}, Numerics::Legacy)
                              .text))
        << seed;
    EXPECT_TRUE(validates(
        emitGlsl(testing::randomVertexProgram(seed, {.wild = true}), {}, Numerics::Legacy).text,
        "vert"))
        << seed;
  }
}

/// Returns a value that an application may send for a fragment attribute.
float sent(const ir::Attribute &attribute, int component, testing::Random &random) {
  const float value = testing::kSpecials[std::size_t(random.below(testing::kSpecials.size()))];
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
  case AttributeKind::ColorSecondary:
    return std::isfinite(value) ? std::fmod(value, 65536.0f) : 1.0f;
  case AttributeKind::FogCoord:
    return component == 0 ? value : component == 3 ? 1.0f : 0.0f;
  case AttributeKind::Position:
    return component == 3 ? value : component == 2 ? random.real(0, 1) : random.real(0, 4096);
  default:
    return value;
  }
}

/// Checks that the interpreter's results of a program stay within the analysed ranges.
void expectWithin(const ir::Program &program, Numerics numerics, std::uint64_t seed) {
  testing::Random random(seed);
  const auto special = [&] {
    return testing::kSpecials[std::size_t(random.below(testing::kSpecials.size()))];
  };
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &attribute : program.attributes) {
    ir::Vec4 value;
    for (int i = 0; i < 4; ++i)
      value[std::size_t(i)] = sent(attribute, i, random);
    attributes.push_back(value);
  }
  RangeAnalysis ranges(program, ir::numericsOf(program.language, numerics));
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.numerics = numerics;
  inputs.parameter = [&](const ir::Parameter &) {
    return ir::Vec4{special(), special(), special(), special()};
  };
  inputs.texture = [&](const ir::Sample &sample) {
    return ir::isShadow(sample.target) ? ir::Vec4{1, 0, 0.5f, 1}
                                       : ir::Vec4{special(), special(), special(), special()};
  };
  inputs.result = [&](const ir::Instruction &instruction, ir::Vec4 &result) {
    ranges.step(instruction);
    if (instruction.dst.file != ir::File::Temporary)
      return;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(instruction.dst.mask >> i & 1))
        continue;
      const float value = instruction.dst.saturate ? ir::saturated(result[i]) : result[i];
      const ValueRange &known = ranges.temporary(instruction.dst.index)[i];
      const bool within =
          std::isnan(value) ? !known.number : value >= known.lo && value <= known.hi;
      EXPECT_TRUE(within) << ir::info(instruction.op).mnemonic << " gave " << value << ", known "
                          << known.lo << " to " << known.hi << (known.number ? "" : " or NaN")
                          << ", seed " << seed << ", mode " << int(numerics);
    }
  };
  (void)ir::evaluate(program, inputs);
}

TEST(Ranges, HoldForWhatTheInterpreterComputes) {
  for (const Numerics numerics : {Numerics::Host, Numerics::Legacy, Numerics::Fp24})
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
      expectWithin(testing::randomProgram(seed, {.wild = seed % 2 == 0, .kills = false}), numerics,
                   seed);
}

} // namespace
} // namespace arbiter::fp::glsl
