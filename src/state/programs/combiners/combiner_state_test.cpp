// Checks register combiners as draws see them: which changes make another program, and which
// queries the host gets.
#include "state/programs/combiners/combiner_state.h"

#include <gtest/gtest.h>

#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

class CombinerHost : public FakeHost {
public:
  CombinerHost() {
    integers[GL_ACTIVE_TEXTURE] = GL_TEXTURE0;
    integers[GL_MAX_TEXTURE_UNITS] = 4;
  }
};

/// Sets variable A of the colour portion of stage 0.
void input(Context &context, GLenum name) {
  handlers::CombinerInputNV(context, GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, name,
                            GL_UNSIGNED_IDENTITY_NV, GL_RGB);
}

TEST(CombinerState, ADrawHasTheirProgram) {
  CombinerHost host;
  const CurrentContext context(host);
  ASSERT_TRUE(context->combiners);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 0u) << "not enabled";
  handlers::Enable(*context, GL_REGISTER_COMBINERS_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  ASSERT_TRUE(context->effective.linkedProgram);
  EXPECT_EQ(context->effective.linkedProgram->fragment.compiled->target, Target::Combiners);
  const LinkedProgram *const linked = context->effective.linkedProgram;
  input(*context, GL_SECONDARY_COLOR_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_NE(context->effective.linkedProgram, linked);
  input(*context, GL_PRIMARY_COLOR_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.linkedProgram, linked) << "made once";
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 2u);
}

TEST(CombinerState, WhatIsNotReadMakesNoProgram) {
  CombinerHost host;
  const CurrentContext context(host);
  handlers::Enable(*context, GL_REGISTER_COMBINERS_NV);
  ASSERT_TRUE(draw(*context));
  const LinkedProgram *const linked = context->effective.linkedProgram;
  handlers::CombinerInputNV(*context, GL_COMBINER3_NV, GL_RGB, GL_VARIABLE_A_NV, GL_FOG,
                            GL_SIGNED_NEGATE_NV, GL_RGB); // only one stage is active
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.linkedProgram, linked);
}

TEST(CombinerState, AConstantChoosesNothing) {
  CombinerHost host;
  const CurrentContext context(host);
  handlers::Enable(*context, GL_REGISTER_COMBINERS_NV);
  input(*context, GL_CONSTANT_COLOR1_NV);
  ASSERT_TRUE(draw(*context));
  const std::uint64_t selections = context->effective.selections;
  const GLfloat color[] = {0.25f, 0, 0, 1};
  handlers::CombinerParameterfvNV(*context, GL_CONSTANT_COLOR1_NV, color);
  input(*context, GL_CONSTANT_COLOR1_NV); // unchanged
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.selections, selections);
  EXPECT_EQ(context->row(Target::Combiners).env[1][0], 0.25f);
}

/// A query is cheap beside a large draw, but not beside a small one.
TEST(CombinerState, DrawsAskForDepthsOnceAfterAChange) {
  CombinerHost host;
  const CurrentContext context(host);
  host.enabled.insert(GL_TEXTURE_2D);
  handlers::Enable(*context, GL_REGISTER_COMBINERS_NV);
  input(*context, GL_TEXTURE0);
  ASSERT_TRUE(draw(*context));
  host.queries = 0;
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.queries, 0);
  handlers::TexImage2D(*context, GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0,
                       GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  host.queries = 0;
  ASSERT_TRUE(draw(*context));
  EXPECT_GT(host.queries, 0);
  host.queries = 0;
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.queries, 0);
  handlers::BindTexture(*context, GL_TEXTURE_2D, 1);
  ASSERT_TRUE(draw(*context));
  EXPECT_GT(host.queries, 0);
}

TEST(CombinerState, AStackSharesTheSettings) {
  CombinerHost host;
  const CurrentContext context(host);
  const auto before = context->combiners->settings();
  input(*context, GL_FOG);
  EXPECT_EQ(before->state.stages[0].rgb.inputs[0].source, fp::combiners::Register::Primary);
  context->combiners->restore(*context, before);
  EXPECT_EQ(context->combiners->settings(), before);
}

} // namespace
} // namespace arbiter::state
