// Checks which calls the host gets for GLSL vertex and fragment programs that are each linked
// alone.
#include "state/host_draw/stages/stage_pipeline.h"

#include <gtest/gtest.h>

#include "state/lifecycle/lifecycle.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

/// Returns a program with conditional writes, which no ARB text can express.
/// \param more makes another program of it
std::string choosing(const std::string &more = "") {
  return "!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP r;\nMOV result.position, vertex.position;\n"
         "MOVC r, vertex.color;\nMOV r (LT.x), program.env[3];\nMOV result.color, r;\n" +
         more + "END\n";
}
constexpr char kStageShading[] =
    "!!ARBfp1.0\nMUL result.color, fragment.color, program.env[1];\nEND\n";

class StagePipelines : public ::testing::Test {
protected:
  StagePipelines() : m_context(m_host) {
    m_context->row(Target::Vertex).limits.nvOptions = 2;
    m_context->caps.onProcessor = m_context->caps.pipelines = true;
    m_host.integers[GL_PROGRAM_PIPELINE_BINDING] = 0;
  }

  [[nodiscard]] GLuint boundPipeline() {
    return GLuint(m_host.integers[GL_PROGRAM_PIPELINE_BINDING]);
  }
  [[nodiscard]] bool drawsApart() {
    return draw(*m_context) && boundPipeline() != 0 && m_host.currentProgram == 0;
  }

  FakeHost m_host;
  CurrentContext m_context;
};

TEST_F(StagePipelines, AFragmentProgramIsLinkedOnceForAllItsPairs) {
  use(*m_context, kStageShading);
  for (int i = 0; i < 5; ++i) {
    use(*m_context, choosing("#" + std::to_string(i) + "\n"), kVertex);
    ASSERT_TRUE(drawsApart());
    EXPECT_EQ(m_host.count("LinkProgram"), 2 + i);
    EXPECT_EQ(m_host.count("ProgramParameteri"), 2 + i) << "separable";
  }
  EXPECT_EQ(m_host.count("BindProgramPipeline"), 5 * 2 - 1) << "setting one up unbinds it";
  EXPECT_EQ(m_host.count("UseProgramStages"), 6);
  use(*m_context, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("LinkProgram"), 7) << "the vertex program is linked already";
}

TEST_F(StagePipelines, ParametersGoToTheirStage) {
  use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  handlers::ProgramEnvParameter4fARB(*m_context, kVertex, 3, 1, 0, 0, 0);
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("ProgramUniform4fv"), 1) << "the other's is zero, as uniforms begin";
  m_host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*m_context, kFragment, 1, 1, 0, 0, 0);
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("ProgramUniform4fv"), 1);
  EXPECT_EQ(m_host.count("Uniform4fv"), 0) << "no program is current";
  m_host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*m_context, kVertex, 3, 1, 0, 0, 0);
  ASSERT_TRUE(drawsApart());
  EXPECT_TRUE(m_host.calls.empty()) << m_host.calls.front();
}

TEST_F(StagePipelines, OnlyWhereTheyPay) {
  for (const bool pipelines : {false, true}) {
    m_context->caps.pipelines = pipelines;
    m_context->caps.onProcessor = !pipelines;
    m_host.calls.clear();
    use(*m_context, choosing("#" + std::to_string(pipelines) + "\n"), kVertex);
    use(*m_context, kStageShading);
    ASSERT_TRUE(draw(*m_context));
    EXPECT_EQ(boundPipeline(), 0u);
    EXPECT_NE(m_host.currentProgram, 0u);
    EXPECT_EQ(m_host.count("LinkProgram"), 1) << "to each other";
    EXPECT_EQ(m_host.count("ProgramParameteri"), 0);
  }
}

TEST_F(StagePipelines, OtherProgramsTakeItsPlace) {
  const GLuint chooses = use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  ASSERT_TRUE(drawsApart());
  const GLuint plain = use(*m_context,
                           "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV "
                           "result.color, vertex.color;\nEND\n",
                           kVertex);
  for (int turn = 0; turn < 2; ++turn) {
    handlers::BindProgramARB(*m_context, kVertex, plain);
    ASSERT_TRUE(draw(*m_context));
    EXPECT_EQ(boundPipeline(), 0u);
    EXPECT_TRUE(m_host.targets[kVertex]);
    EXPECT_TRUE(m_host.targets[kFragment]) << "assembly as well";
    EXPECT_EQ(m_host.currentProgram, 0u);
    handlers::BindProgramARB(*m_context, kVertex, chooses);
    ASSERT_TRUE(drawsApart());
    EXPECT_FALSE(m_host.targets[kVertex]);
    EXPECT_FALSE(m_host.targets[kFragment]);
  }
  EXPECT_EQ(m_host.count("LinkProgram"), 2);
  handlers::Disable(*m_context, kFragment);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(boundPipeline(), 0u);
  EXPECT_NE(m_host.currentProgram, 0u) << "its stage beside fixed function's";
  EXPECT_EQ(m_host.count("LinkProgram"), 2);
  handlers::Disable(*m_context, kVertex);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_host.currentProgram, 0u);
}

TEST_F(StagePipelines, TheApplicationSeesNone) {
  use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  ASSERT_TRUE(drawsApart());
  const GLuint pipeline = boundPipeline();
  GLint value = -1;
  handlers::GetIntegerv(*m_context, GL_PROGRAM_PIPELINE_BINDING, &value);
  EXPECT_EQ(value, 0);
  handlers::GetIntegerv(*m_context, GL_CURRENT_PROGRAM, &value);
  EXPECT_EQ(value, 0);
  EXPECT_NE(handlers::guardPipeline(*m_context, pipeline), pipeline);
  EXPECT_EQ(handlers::guardPipeline(*m_context, 0), 0u);
  EXPECT_EQ(handlers::guardPipeline(*m_context, pipeline + 1), pipeline + 1);
  const GLuint names[] = {pipeline, 4711};
  handlers::DeleteProgramPipelines(*m_context, 2, names);
  EXPECT_EQ(m_host.count("DeleteProgramPipeline " + std::to_string(pipeline)), 0);
  EXPECT_EQ(m_host.count("DeleteProgramPipeline 4711"), 1);
  handlers::DeleteProgramPipelines(*m_context, -1, nullptr); // the host raises the error
  ASSERT_TRUE(drawsApart());
  handlers::restoreApplicationProgram(*m_context);
  EXPECT_EQ(boundPipeline(), 0u);
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("LinkProgram"), 2);
}

TEST_F(StagePipelines, TheApplicationsProgramsGoFirst) {
  use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  ASSERT_TRUE(drawsApart());
  m_host.programs.insert(77);
  m_host.stages[77] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  handlers::UseProgram(*m_context, 77);
  EXPECT_EQ(boundPipeline(), 0u);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::ApplicationGlsl);
  handlers::UseProgram(*m_context, 0);
  ASSERT_TRUE(drawsApart());
  handlers::BindProgramPipeline(*m_context, 88); // it has no stages here
  EXPECT_EQ(boundPipeline(), 88u);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::ApplicationPipeline);
  EXPECT_EQ(boundPipeline(), 88u);
  handlers::BindProgramPipeline(*m_context, 0);
  ASSERT_TRUE(drawsApart());
  // A host list compiled before the first program may have changed anything.
  m_context->group->hostListsChangeProgram = true;
  m_host.lists.insert(7);
  handlers::CallList(*m_context, 7);
  ASSERT_TRUE(drawsApart());
  m_host.currentProgram = 77;
  handlers::CallList(*m_context, 7);
  EXPECT_EQ(boundPipeline(), 0u);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::ApplicationGlsl);
}

TEST_F(StagePipelines, ProgramsThatAreDeletedLeaveNothing) {
  const GLuint fragment = use(*m_context, kStageShading);
  const GLuint vertex = use(*m_context, choosing(), kVertex);
  ASSERT_TRUE(drawsApart());
  ASSERT_EQ(m_host.programs.size(), 2u);
  handlers::DeleteProgramsARB(*m_context, 1, &vertex);
  EXPECT_EQ(m_host.programs.size(), 1u);
  EXPECT_EQ(m_host.count("UseProgramStages"), 3) << "the pipeline would keep it";
  handlers::DeleteProgramsARB(*m_context, 1, &fragment);
  EXPECT_TRUE(m_host.programs.empty());
  EXPECT_TRUE(m_host.shaders.empty());
  for (int i = 0; i < 100; ++i) {
    load(*m_context, choosing("#" + std::to_string(i) + "\n"), kVertex);
    use(*m_context, choosing("#" + std::to_string(i) + "\n"), kVertex);
    use(*m_context, kStageShading);
    ASSERT_TRUE(drawsApart());
    load(*m_context, choosing("#" + std::to_string(i) + "b\n"), kVertex);
    ASSERT_TRUE(drawsApart());
  }
}

TEST_F(StagePipelines, ResultsThatNothingWritesAreOfThePairAlone) {
  use(*m_context, choosing(), kVertex);
  const GLuint reads =
      use(*m_context, "!!ARBfp1.0\nMOV result.color, fragment.texcoord[2];\nEND\n");
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("LinkProgram"), 2);
  handlers::ProgramEnvParameter4fARB(*m_context, kVertex, 3, 1, 0, 0, 0);
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("ProgramUniform4fv"), 1);
  use(*m_context, kStageShading);
  ASSERT_TRUE(drawsApart());
  EXPECT_EQ(m_host.count("LinkProgram"), 4)
      << "the vertex program alone, and the other's fragments";
  handlers::DeleteProgramsARB(*m_context, 1, &reads);
  EXPECT_EQ(m_host.programs.size(), 2u) << "its fragments, and the vertex program that it had";
}

TEST_F(StagePipelines, WhatTheHostDoesNotLinkIsRefused) {
  m_host.linkFails = true;
  use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  EXPECT_FALSE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::HostRefused);
  EXPECT_EQ(boundPipeline(), 0u);
}

TEST_F(StagePipelines, TheRasterPositionIsThatOfTheVertexProgramAlone) {
  use(*m_context, choosing(), kVertex);
  use(*m_context, kStageShading);
  ASSERT_TRUE(drawsApart());
  EXPECT_FALSE(m_context->stagesAreLinked) << "it has all its results";
}

TEST(StagePipeline, AContextThatEndsLeavesItsProgramsToTheGroup) {
  FakeHost host;
  const CurrentContext first(host);
  {
    const CurrentContext second(host, &*first);
    second->row(Target::Vertex).limits.nvOptions = 2;
    second->caps.onProcessor = second->caps.pipelines = true;
    use(*second, choosing(), kVertex);
    use(*second, kStageShading);
    ASSERT_TRUE(draw(*second));
    use(*second, "!!ARBfp1.0\nMOV result.color, fragment.texcoord[2];\nEND\n");
    ASSERT_TRUE(draw(*second));
    EXPECT_EQ(host.programs.size(), 4u);
  }
  makeCurrent(&*first);
  use(*first, kStageShading);
  ASSERT_TRUE(draw(*first));
  EXPECT_EQ(host.programs.size(), 1u);
}

} // namespace
} // namespace arbiter::state
