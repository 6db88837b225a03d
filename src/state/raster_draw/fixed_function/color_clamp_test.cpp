// Checks that NaN in vertex colours is clamped as the host does.
#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/raster_draw/fixed_function/fixed_vertex.h"

#include <array>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/validate.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
namespace {

using fp::ir::AttributeKind;
using fp::ir::OutputKind;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Returns the front colour that the program makes of a primary colour. Requires that all
/// parameters are constants.
fp::ir::Vec4 colorOf(const fp::ir::Program &program, const fp::ir::Vec4 &primary) {
  EXPECT_EQ(fp::ir::validate(program), std::vector<std::string>{});
  const std::vector<fp::ir::Vec4> attributes(program.attributes.size(), primary);
  fp::ir::Inputs inputs;
  inputs.attributes = attributes;
  const fp::ir::Evaluation evaluation = fp::ir::evaluate(program, inputs);
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i] == fp::ir::Output{OutputKind::FrontPrimary, 0})
      return evaluation.outputs[i];
  ADD_FAILURE() << "no colour is written";
  return {};
}

/// Returns a program that writes the colour in two parts, one of them computed.
fp::ir::Program ownProgram() {
  fp::ir::Builder b(fp::ir::Language::ArbVertex);
  const fp::ir::Target color = b.result(OutputKind::FrontPrimary);
  const fp::ir::Source in = b.attribute(AttributeKind::ColorPrimary);
  b.op(fp::ir::Opcode::Mul, color.mask("xz"), {in, b.constant(1)});
  b.op(fp::ir::Opcode::Mov, color.mask("yw"), {in});
  return b.take();
}

TEST(ColorClamp, WhatIsNoNumberBecomesWhatTheHostMakesOfIt) {
  const fp::ir::Vec4 color = {kNan, 2, -1, 0.25f};
  for (const auto &[clamp, wanted] :
       {std::pair(ColorClamp::NanIsZero, 0.0f), std::pair(ColorClamp::NanIsOne, 1.0f)}) {
    const fp::ir::Vec4 clamped = {wanted, 1, 0, 0.25f};
    FixedVertexKey key;
    key.needs.primary = true;
    key.clampColors = clamp;
    EXPECT_EQ(colorOf(makeFixedVertexProgram(key), color), clamped) << "fixed function";
    EXPECT_EQ(colorOf(withFixedPosition(ownProgram(), 0, clamp), color), clamped) << "a program";
  }
}

TEST(ColorClamp, WithoutItColorsStay) {
  const fp::ir::Vec4 color = {3, 2, -1, 0.25f};
  FixedVertexKey key;
  key.needs.primary = true;
  EXPECT_EQ(colorOf(makeFixedVertexProgram(key), color), color);
  EXPECT_EQ(colorOf(withFixedPosition(ownProgram(), 0, ColorClamp::None), color), color);
}

/// HostCaps decides by the host's name, so a draw checks what the host really does.
TEST(ColorClamp, TheHostClampsAsItsCapsSay) {
  const testing::RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  // Each vertex sets a colour: Mesa itself clamps a constant colour set before Begin.
  glBegin(GL_TRIANGLES);
  glColor4f(kNan, 0.5f, 0, 1);
  glVertex2f(-1, -1);
  glVertex2f(3, -1);
  glVertex2f(-1, 3);
  glEnd();
  std::array<std::uint8_t, 4> pixel{};
  glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel[0], host.context().caps.clampsNanToOne ? 255 : 0);
  EXPECT_NEAR(pixel[1], 128, 1);
}

} // namespace
} // namespace arbiter::state
