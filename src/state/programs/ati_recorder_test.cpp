// Checks what the recorder builds: pairs, passes, masks and modifiers. Tests of the API check which
// commands are errors (tests/layer_vs_specification/ati_errors_test.cpp).
#include "state/programs/ati_recorder.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

using fp::ati::Coordinates;
using fp::ati::Op;
using fp::ati::Replicate;
using fp::ati::Scale;
using fp::ati::SetupKind;
using fp::ati::Source;
using RawOperation = AtiRecorder::RawOperation;

constexpr RawOperation kColorMov = {.op = GL_MOV_ATI,
                                    .destination = GL_REG_1_ATI,
                                    .arguments = {{{GL_CON_2_ATI, GL_NONE, GL_NONE}}}};

RawOperation alpha(RawOperation operation) {
  operation.alpha = true;
  return operation;
}

TEST(AtiRecorder, PairsFormFromColorThenAlpha) {
  AtiRecorder recorder(8, 8);
  EXPECT_EQ(recorder.operation(alpha(kColorMov)).error, GLenum(GL_NO_ERROR));
  EXPECT_EQ(recorder.operation(kColorMov).error, GLenum(GL_NO_ERROR));
  EXPECT_EQ(recorder.operation(alpha(kColorMov)).error, GLenum(GL_NO_ERROR));
  EXPECT_EQ(recorder.operation(alpha(kColorMov)).error, GLenum(GL_NO_ERROR));
  const fp::ati::Pass &pass = recorder.shader().passes[0];
  ASSERT_EQ(recorder.shader().passCount, 1);
  ASSERT_EQ(pass.pairCount, 3);
  EXPECT_FALSE(pass.pairs[0].color);
  EXPECT_TRUE(pass.pairs[1].color && pass.pairs[1].alpha);
  EXPECT_FALSE(pass.pairs[2].color);
  EXPECT_EQ(recorder.end().error, GLenum(GL_NO_ERROR));
}

TEST(AtiRecorder, SetupAfterAnOperationBeginsThePass) {
  AtiRecorder recorder(8, 8);
  const auto setup = [&](SetupKind kind, GLuint dst, GLuint source, GLenum swizzle) {
    EXPECT_EQ(recorder.setup(kind, dst, source, swizzle).error, GLenum(GL_NO_ERROR));
  };
  setup(SetupKind::SampleMap, GL_REG_2_ATI, GL_TEXTURE7, GL_SWIZZLE_STQ_DQ_ATI);
  EXPECT_EQ(recorder.operation(kColorMov).error, GLenum(GL_NO_ERROR));
  setup(SetupKind::PassTexCoord, GL_REG_3_ATI, GL_REG_2_ATI, GL_SWIZZLE_STR_DR_ATI);
  EXPECT_EQ(recorder.operation(alpha(kColorMov)).error, GLenum(GL_NO_ERROR));
  const fp::ati::Shader &shader = recorder.shader();
  ASSERT_EQ(shader.passCount, 2);
  const fp::ati::Setup &first = shader.passes[0].setups[2];
  EXPECT_EQ(first.kind, SetupKind::SampleMap);
  EXPECT_FALSE(first.fromRegister);
  EXPECT_EQ(first.source, 7);
  EXPECT_EQ(first.coordinates, Coordinates::StqDq);
  const fp::ati::Setup &second = shader.passes[1].setups[3];
  EXPECT_EQ(second.kind, SetupKind::PassTexCoord);
  EXPECT_TRUE(second.fromRegister);
  EXPECT_EQ(second.source, 2);
  EXPECT_EQ(second.coordinates, Coordinates::StrDr);
  EXPECT_FALSE(shader.passes[1].pairs[0].color) << "pairs do not reach over a pass's start";
}

TEST(AtiRecorder, EveryModifierArrives) {
  AtiRecorder recorder(8, 8);
  const RawOperation raw = {
      .argumentCount = 3,
      .op = GL_LERP_ATI,
      .destination = GL_REG_5_ATI,
      .mask = GL_RED_BIT_ATI | GL_BLUE_BIT_ATI,
      .modifiers = GL_QUARTER_BIT_ATI | GL_SATURATE_BIT_ATI,
      .arguments = {{{GL_REG_4_ATI, GL_ALPHA, GL_COMP_BIT_ATI | GL_2X_BIT_ATI},
                     {GL_PRIMARY_COLOR_ARB, GL_GREEN, GL_BIAS_BIT_ATI | GL_NEGATE_BIT_ATI},
                     {GL_ONE, GL_NONE, GL_NONE}}}};
  ASSERT_EQ(recorder.operation(raw).error, GLenum(GL_NO_ERROR));
  const fp::ati::Operation &operation = *recorder.shader().passes[0].pairs[0].color;
  EXPECT_EQ(operation.op, Op::Lerp);
  EXPECT_EQ(operation.destination, 5);
  EXPECT_EQ(operation.mask, 5);
  EXPECT_EQ(operation.scale, Scale::Quarter);
  EXPECT_TRUE(operation.saturate);
  const fp::ati::Argument expected[] = {
      {.source = Source::Register,
       .index = 4,
       .replicate = Replicate::Alpha,
       .complement = true,
       .twice = true},
      {.source = Source::Primary, .replicate = Replicate::Green, .bias = true, .negate = true},
      {.source = Source::One}};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(operation.arguments[i], expected[i]) << i;
}

TEST(AtiRecorder, AnErrorLeavesTheShaderAsItWas) {
  AtiRecorder recorder(8, 8);
  ASSERT_EQ(recorder.operation(kColorMov).error, GLenum(GL_NO_ERROR));
  EXPECT_NE(
      recorder.setup(SetupKind::SampleMap, GL_CON_0_ATI, GL_TEXTURE0, GL_SWIZZLE_STR_ATI).error,
      GLenum(GL_NO_ERROR));
  RawOperation bad = kColorMov;
  bad.arguments[0].source = GL_TEXTURE0;
  EXPECT_EQ(recorder.operation(bad).error, GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(recorder.operation(alpha(kColorMov)).error, GLenum(GL_NO_ERROR));
  EXPECT_EQ(recorder.shader().passCount, 1) << "no second pass began";
  EXPECT_EQ(recorder.shader().passes[0].pairCount, 1) << "and alpha still joins its colour";
}

TEST(AtiRecorder, UnitsOfTheImplementation) {
  AtiRecorder recorder(4, 2);
  EXPECT_EQ(
      recorder.setup(SetupKind::SampleMap, GL_REG_4_ATI, GL_TEXTURE0, GL_SWIZZLE_STR_ATI).error,
      GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(
      recorder.setup(SetupKind::SampleMap, GL_REG_3_ATI, GL_TEXTURE2, GL_SWIZZLE_STR_ATI).error,
      GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(
      recorder.setup(SetupKind::SampleMap, GL_REG_3_ATI, GL_TEXTURE1, GL_SWIZZLE_STR_ATI).error,
      GLenum(GL_NO_ERROR));
}

TEST(AtiRecorder, ConstantsAreTheContextsUntilSet) {
  AtiRecorder recorder(8, 8);
  recorder.setConstant(3, {0.25f, 0.5f, 0.75f, 1.0f});
  const auto &constants = recorder.shader().constants;
  EXPECT_EQ(constants[3].kind, fp::ati::ConstantKind::Value);
  EXPECT_EQ(constants[3].value[2], 0.75f);
  EXPECT_EQ(constants[4].kind, fp::ati::ConstantKind::Env);
  EXPECT_EQ(constants[4].index, 4);
}

TEST(AtiRecorder, ConstantsAreNumbers) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  AtiRecorder recorder(8, 8);
  recorder.setConstant(0, {std::nanf(""), kInfinity, -kInfinity, -0.5f});
  const fp::ir::Vec4 &value = recorder.shader().constants[0].value;
  EXPECT_EQ(value[0], 0.0f);
  EXPECT_EQ(value[1], std::numeric_limits<float>::max());
  EXPECT_EQ(value[2], std::numeric_limits<float>::lowest());
  EXPECT_EQ(value[3], -0.5f) << "kept, though beyond [0,1]";
}

} // namespace
} // namespace arbiter::state
