// Checks when the host is queried for fixed-function state, and what an ATI shader becomes under
// it.
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/texturing/fixed_function_now.h"

#include <gtest/gtest.h>

#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

/// Specifies the bound shader: REG_0 is the texture of unit `unit`, or zero if that is negative.
void specify(Context &context, int unit) {
  handlers::BeginFragmentShaderATI(context);
  if (unit >= 0)
    handlers::SampleMapATI(context, GLuint(GL_REG_0_ATI + unit), GL_TEXTURE0, GL_SWIZZLE_STR_ATI);
  handlers::ColorFragmentOp1ATI(context, GL_MOV_ATI, GL_REG_0_ATI, GL_NONE, GL_NONE,
                                unit < 0 ? GLuint(GL_ZERO) : GLuint(GL_REG_0_ATI + unit), GL_NONE,
                                GL_NONE);
  handlers::EndFragmentShaderATI(context);
}

TEST(FixedFunctionState, ADrawAsksOnceAndThenNothing) {
  FakeHost host;
  const CurrentContext context(host);
  specify(*context, 3);
  handlers::Enable(*context, GL_FRAGMENT_SHADER_ATI);
  host.enabled = {GL_TEXTURE_2D};
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  EXPECT_GT(host.count("IsEnabled"), 0);
  host.calls.clear();
  ASSERT_TRUE(draw(*context));
  handlers::Enable(*context, GL_DEPTH_TEST); // does not matter to the shader
  handlers::Fogf(*context, GL_FOG_DENSITY, 2);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("IsEnabled"), 0);
  EXPECT_EQ(host.count("UseProgram"), 0);
}

TEST(FixedFunctionState, WhatChangesItIsSeen) {
  FakeHost host;
  const CurrentContext context(host);
  specify(*context, 3);
  handlers::Enable(*context, GL_FRAGMENT_SHADER_ATI);
  host.enabled = {GL_TEXTURE_2D};
  ASSERT_TRUE(draw(*context));
  const LinkedProgram *const flat = context->effective.linkedProgram;
  const auto expectAnother = [&](const char *after) {
    ASSERT_TRUE(draw(*context));
    EXPECT_NE(context->effective.linkedProgram, flat) << after;
  };
  host.enabled = {GL_TEXTURE_2D, GL_TEXTURE_3D};
  handlers::Enable(*context, GL_TEXTURE_3D);
  expectAnother("Enable");
  host.enabled = {GL_TEXTURE_2D};
  handlers::Disable(*context, GL_TEXTURE_3D);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.linkedProgram, flat) << "a form is made once";
  host.enabled = {GL_TEXTURE_2D, GL_FOG};
  handlers::PopAttrib(*context);
  expectAnother("PopAttrib");
  const LinkedProgram *const fog = context->effective.linkedProgram;
  host.integers[GL_FOG_MODE] = GL_LINEAR;
  handlers::Fogi(*context, GL_FOG_MODE, GL_LINEAR);
  expectAnother("Fog");
  EXPECT_NE(context->effective.linkedProgram, fog);
  host.enabled = {GL_TEXTURE_2D, GL_COLOR_SUM};
  handlers::CallList(*context, 7);
  expectAnother("CallList");
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 5u);
}

TEST(FixedFunctionState, UnitsThatAreNotSampledMakeNoForms) {
  FakeHost host;
  const CurrentContext context(host);
  specify(*context, -1);
  handlers::Enable(*context, GL_FRAGMENT_SHADER_ATI);
  ASSERT_TRUE(draw(*context));
  host.enabled = {GL_TEXTURE_CUBE_MAP};
  handlers::Enable(*context, GL_TEXTURE_CUBE_MAP);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 1u);
  EXPECT_EQ(host.count("ActiveTexture"), 0) << "no unit is looked at";
}

TEST(FixedFunctionState, NobodyAsksWithoutAnAtiShader) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, "!!ARBfp1.0\nMOV result.color, 1;\nEND");
  ASSERT_TRUE(draw(*context));
  handlers::Enable(*context, GL_FOG);
  handlers::Fogi(*context, GL_FOG_MODE, GL_LINEAR);
  EXPECT_EQ(context->attention, 0u);
  EXPECT_EQ(host.count("IsEnabled"), 0);
}

TEST(FixedFunctionState, LightingDecidesAboutTheSecondaryColor) {
  FakeHost host;
  const CurrentContext context(host);
  host.integers[GL_LIGHT_MODEL_COLOR_CONTROL] = GL_SINGLE_COLOR;
  EXPECT_FALSE(fixedFunctionNow(*context, 0).colorSum);
  host.enabled = {GL_COLOR_SUM};
  EXPECT_TRUE(fixedFunctionNow(*context, 0).colorSum);
  host.enabled = {GL_COLOR_SUM, GL_LIGHTING};
  EXPECT_FALSE(fixedFunctionNow(*context, 0).colorSum) << "it is black";
  host.integers[GL_LIGHT_MODEL_COLOR_CONTROL] = GL_SEPARATE_SPECULAR_COLOR;
  host.enabled = {GL_LIGHTING};
  EXPECT_TRUE(fixedFunctionNow(*context, 0).colorSum);
  context->row(Target::Vertex).offered = context->row(Target::Vertex).enabled = true;
  EXPECT_FALSE(fixedFunctionNow(*context, 0).colorSum) << "a vertex program knows no lighting";
}

} // namespace
} // namespace arbiter::state
