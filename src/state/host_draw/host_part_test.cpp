// Checks that a program the rasterizer draws with is not given to the host until the host has a
// draw.
#include <gtest/gtest.h>

#include "state/host_draw/draw.h"
#include "state/objects/linked_program.h"
#include "state/raster_draw/context_state.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kRed[] = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND";
constexpr char kGreen[] = "!!ARBfp1.0\nADD result.color, program.local[0], fragment.color;\nEND";

/// A context whose draws the rasterizer may do.
class HostPartWaits : public ::testing::Test {
protected:
  HostPartWaits() : m_context(m_host) {
    m_context->software = std::make_unique<ContextState>(*m_context);
    m_context->softwarePossible = m_context->softwareListens = true;
    m_host.calls.clear();
  }
  /// Acts as a draw of the rasterizer.
  void rasterize() { ASSERT_TRUE(validatePrograms(*m_context)); }
  int callsOf(const std::string &name) const {
    int count = 0;
    for (const std::string &call : m_host.calls)
      count += int(call.starts_with(name));
    return count;
  }

  FakeHost m_host;
  CurrentContext m_context;
};

TEST_F(HostPartWaits, UntilTheHostDraws) {
  use(*m_context, kRed);
  rasterize();
  ASSERT_NE(m_context->effective.linkedProgram, nullptr);
  EXPECT_NE(m_context->effective.linkedProgram->fragment.compiled, nullptr);
  EXPECT_TRUE(m_host.shaders.empty());
  EXPECT_EQ(callsOf("UseProgram"), 0);
  const std::uint64_t selections = m_context->effective.selections;

  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_host.currentProgram, m_context->effective.linkedProgram->hostProgram);
  EXPECT_NE(m_host.currentProgram, 0u);
  // The rasterizer's choice for these programs must stay valid.
  EXPECT_EQ(m_context->effective.selections, selections);
  EXPECT_EQ(m_context->attention & attention::kHostPart, 0u);

  m_host.calls.clear();
  rasterize();
  ASSERT_TRUE(draw(*m_context));
  EXPECT_TRUE(m_host.calls.empty()) << m_host.calls.front();
}

TEST_F(HostPartWaits, AssemblyOfTheVertexStageTooAndItsParameters) {
  use(*m_context, kRed);
  use(*m_context, kPlacingText, kVertex);
  handlers::ProgramLocalParameter4fARB(*m_context, kFragment, 0, 1, 2, 3, 4);
  rasterize();
  EXPECT_TRUE(m_host.assembly.empty());
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_host.assembly.size(), 1u);
  EXPECT_TRUE(m_host.targets[kVertex]);
  EXPECT_EQ(m_host.uniforms.begin()->second, (std::vector<GLfloat>{1, 2, 3, 4}));
}

TEST_F(HostPartWaits, ProgramsThatTheHostNeverDrawsWithAreNeverItsOwn) {
  const GLuint red = use(*m_context, kRed);
  rasterize();
  const GLuint green = use(*m_context, kGreen);
  rasterize();
  for (int i = 0; i < 100; ++i) {
    handlers::BindProgramARB(*m_context, kFragment, i % 2 == 0 ? red : green);
    rasterize();
  }
  EXPECT_TRUE(m_host.calls.empty()) << m_host.calls.front();
  ASSERT_TRUE(draw(*m_context)); // only green is needed
  EXPECT_EQ(m_host.shaders.size(), 1u);
}

TEST_F(HostPartWaits, ARefusalIsMetAtTheHostsDraw) {
  use(*m_context, kRed);
  rasterize();
  m_host.linkFails = true;
  EXPECT_FALSE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::HostRefused);
  EXPECT_EQ(m_context->effective.linkedProgram, nullptr);
}

TEST_F(HostPartWaits, AnEarlierProgramOfOursIsNotTakenForTheApplications) {
  use(*m_context, kRed);
  ASSERT_TRUE(draw(*m_context));
  ASSERT_NE(m_host.currentProgram, 0u);
  use(*m_context, kGreen);
  rasterize();
  m_context->group->hostListsChangeProgram = true;
  afterHostList(*m_context);
  EXPECT_EQ(m_context->application.program, 0u);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_context->effective.path, Path::HostGlsl);
}

TEST_F(HostPartWaits, AProgramThatIsDeletedMeanwhileLeavesNothing) {
  GLuint name = use(*m_context, kRed);
  rasterize();
  handlers::DeleteProgramsARB(*m_context, 1, &name);
  (void)draw(*m_context);
  EXPECT_TRUE(m_host.shaders.empty());
}

TEST_F(HostPartWaits, FixedFunctionInsteadLetsTheHostGo) {
  use(*m_context, kRed);
  ASSERT_TRUE(draw(*m_context));
  use(*m_context, kGreen);
  rasterize();
  handlers::Disable(*m_context, kFragment);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_EQ(m_host.currentProgram, 0u);
  EXPECT_FALSE(m_context->effective.hostPartWaits);
}

} // namespace
} // namespace arbiter::state
