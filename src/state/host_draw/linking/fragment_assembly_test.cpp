// Checks which fragment programs are the host's own, where the rasterizer draws and over a host
// that draws them correctly, and which are GLSL.
#include "state/host_draw/linking/fragment_assembly.h"

#include <gtest/gtest.h>

#include "state/host_draw/change_pace.h"
#include "state/lifecycle/lifecycle.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/context_state.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kVertices[] =
    "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, vertex.color;\nEND\n";
constexpr char kShading[] =
    "!!ARBfp1.0\nMUL result.color, fragment.color, program.local[2];\nEND\n";
constexpr char kReading[] = "!!ARBfp1.0\nMOV result.color, fragment.texcoord[1];\nEND\n";
constexpr char kFogText[] =
    "!!ARBfp1.0\nOPTION ARB_fog_linear;\nMOV result.color, fragment.color;\nEND\n";

class FragmentDraws : public ::testing::Test {
protected:
  FragmentDraws() : m_context(m_host) {}
  /// Draws, and returns whether the fragments are shaded by the host's own program without linking.
  [[nodiscard]] bool drawsByAssembly() {
    const int links = m_host.count("LinkProgram");
    return draw(*m_context) && m_host.targets[kFragment] && m_host.currentProgram == 0 &&
           m_host.count("LinkProgram") == links;
  }
  [[nodiscard]] bool drawsByGlsl() {
    return draw(*m_context) && !m_host.targets[kFragment] && m_host.currentProgram != 0;
  }

  FakeHost m_host;
  CurrentContext m_context;
};

/// Tests where the rasterizer draws.
class FragmentAssembly : public FragmentDraws {
protected:
  FragmentAssembly() {
    m_context->caps.onProcessor = true;
    m_context->software = std::make_unique<ContextState>(*m_context);
    m_context->softwarePossible = m_context->softwareListens = true;
  }
};

TEST_F(FragmentAssembly, APlainProgramIsBesideEitherVertices) {
  use(*m_context, kShading);
  EXPECT_TRUE(drawsByAssembly());
  EXPECT_FALSE(m_host.targets[kVertex]);
  use(*m_context, kVertices, kVertex);
  EXPECT_TRUE(drawsByAssembly());
  EXPECT_TRUE(m_host.targets[kVertex]);
  EXPECT_EQ(m_host.assembly.size(), 2u) << "each is loaded once";
  handlers::Disable(*m_context, kFragment);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_FALSE(m_host.targets[kFragment]);
  EXPECT_TRUE(m_host.targets[kVertex]);
}

TEST_F(FragmentAssembly, ItsParametersAreSentAsTheyChange) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  const std::string call = "ProgramLocalParameter4fv " + std::to_string(kFragment) + " 2";
  for (int i = 1; i < 4; ++i) {
    handlers::ProgramLocalParameter4fARB(*m_context, kFragment, 2, GLfloat(i), 0, 0, 1);
    ASSERT_TRUE(drawsByAssembly());
    EXPECT_EQ(m_host.count(call), i);
    ASSERT_TRUE(drawsByAssembly());
    EXPECT_EQ(m_host.count(call), i) << "nothing changed";
  }
}

TEST_F(FragmentAssembly, OptionsLongTextsAndOtherHostsAreGlsl) {
  use(*m_context, kFogText);
  EXPECT_TRUE(drawsByGlsl());
  fp::ResourceCounts &api = m_context->row(Target::Fragment).limits.api;
  api.instructions = api.aluInstructions = 1024;
  std::string text = "!!ARBfp1.0\nTEMP r;\nMOV r, fragment.color;\n";
  for (int i = 0; i < 260; ++i)
    text += "MAD r, r, fragment.texcoord[" + std::to_string(i % 8) + "], program.local[" +
            std::to_string(i % 24) + "];\n";
  use(*m_context, text + "MOV result.color, r;\nEND\n");
  EXPECT_TRUE(drawsByGlsl());
  m_context->caps.onProcessor = false;
  use(*m_context, kShading);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(FragmentAssembly, WhatTheHostRefusesIsGlsl) {
  m_host.refusesAssembly = true;
  use(*m_context, kShading);
  EXPECT_TRUE(drawsByGlsl());
  EXPECT_TRUE(drawsByGlsl());
  EXPECT_EQ(m_host.count("LinkProgram"), 1);
  EXPECT_EQ(m_host.error, GLenum(GL_NO_ERROR));
}

TEST_F(FragmentAssembly, ItIsGlslWhereTheHostDrawsWithItInALaterFrame) {
  const GLuint name = use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  ASSERT_TRUE(drawsByAssembly());
  ++m_context->counters.frames;
  EXPECT_TRUE(drawsByGlsl());
  use(*m_context, kReading);
  EXPECT_TRUE(drawsByAssembly()) << "another one, whose first frame this is";
  handlers::BindProgramARB(*m_context, kFragment, name);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(FragmentAssembly, FlatColorsAreGlsl) {
  m_host.integers[GL_SHADE_MODEL] = GL_FLAT;
  const GLuint name = use(*m_context, kShading);
  EXPECT_TRUE(drawsByGlsl());
  use(*m_context, kReading);
  EXPECT_TRUE(drawsByAssembly()) << "it reads none";
  m_host.integers[GL_SHADE_MODEL] = GL_SMOOTH;
  handlers::BindProgramARB(*m_context, kFragment, name);
  EXPECT_TRUE(drawsByGlsl()) << "it is there";
}

TEST_F(FragmentAssembly, ATextureThatComparesMakesItGlsl) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  handlers::TexParameteri(*m_context, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                          GL_COMPARE_R_TO_TEXTURE);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(FragmentAssembly, WhatAnotherContextOfTheGroupSetsEndsIt) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  const CurrentContext other(m_host, &*m_context);
  handlers::TexParameteri(*other, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  makeCurrent(&*m_context);
  EXPECT_TRUE(drawsByGlsl()) << "in the same frame";
}

TEST_F(FragmentAssembly, ADepthTextureOfAlphaMakesItGlsl) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  handlers::TexParameteri(*m_context, GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(FragmentAssembly, AProgramThatIsDeletedLeavesNothing) {
  const GLuint name = use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  handlers::DeleteProgramsARB(*m_context, 1, &name);
  EXPECT_TRUE(m_host.assembly.empty());
  handlers::Disable(*m_context, kFragment);
  ASSERT_TRUE(draw(*m_context));
  EXPECT_FALSE(m_host.targets[kFragment]);
}

/// Tests over a host whose own fragment programs draw correctly.
class OwnFragments : public FragmentDraws {
protected:
  OwnFragments() { m_context->caps.ownFragments = true; }
  /// Draws `count` times as fast as possible, with a changed local parameter each time.
  [[nodiscard]] bool drawChanging(unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      handlers::ProgramLocalParameter4fARB(*m_context, kFragment, 2, GLfloat(++m_value), 0, 0, 1);
      if (!draw(*m_context))
        return false;
    }
    return true;
  }

  /// Draws so until two readings of the clock were less apart than is fast. Returns false where
  /// they never are, as with a sanitizer on a busy machine.
  [[nodiscard]] bool drawFast() {
    constexpr int kTries = 50;
    for (int i = 0; i < kTries; ++i) {
      const auto start = ChangePace::Clock::now();
      if (!drawChanging(2 * ChangePace::kDraws))
        return false;
      if (ChangePace::Clock::now() - start < ChangePace::kDraws * ChangePace::kApart)
        return true;
    }
    return false;
  }

  int m_value = 0;
};

TEST_F(OwnFragments, APlainProgramIsForGood) {
  m_host.integers[GL_SHADE_MODEL] = GL_FLAT;
  const GLuint name = use(*m_context, kShading);
  EXPECT_TRUE(drawsByAssembly());
  ++m_context->counters.frames;
  EXPECT_TRUE(drawsByAssembly());
  use(*m_context, kReading);
  use(*m_context, kVertices, kVertex);
  EXPECT_TRUE(drawsByAssembly()) << "beside a vertex program too";
  ++m_context->counters.frames;
  handlers::BindProgramARB(*m_context, kFragment, name);
  EXPECT_TRUE(drawsByAssembly());
  EXPECT_EQ(m_host.assembly.size(), 4u) << "each is loaded once, that of vertices in two forms";
  EXPECT_EQ(m_host.count("LinkProgram"), 0);
  EXPECT_EQ(m_context->attention, 0u) << "nothing needs to be looked at before a draw";
}

TEST_F(OwnFragments, AProgramWhoseParametersChangeBeforeEachDrawBecomesGlsl) {
  const GLuint reading = use(*m_context, kReading);
  const GLuint changing = use(*m_context, kShading);
  ASSERT_TRUE(drawChanging(ChangePace::kDraws));
  EXPECT_TRUE(drawsByAssembly()) << "few";
  if (!drawFast()) // the rule is about fast draws, and a slow machine has none
    GTEST_SKIP() << "draws are slow here";
  ASSERT_TRUE(drawsByGlsl());
  EXPECT_EQ(m_host.uniforms.begin()->second.at(0), GLfloat(m_value));
  EXPECT_EQ(m_host.count("LinkProgram"), 1);
  handlers::BindProgramARB(*m_context, kFragment, reading);
  EXPECT_TRUE(drawsByAssembly()) << "another one";
  handlers::BindProgramARB(*m_context, kFragment, changing);
  ++m_context->counters.frames;
  EXPECT_TRUE(drawsByGlsl()) << "for good";
  use(*m_context, kVertices, kVertex);
  EXPECT_TRUE(drawsByGlsl()) << "in every pair";
}

TEST_F(OwnFragments, ParametersOfVerticesCountForNone) {
  use(*m_context, kShading);
  use(*m_context, kVertices, kVertex);
  for (unsigned i = 0; i < 4 * ChangePace::kDraws; ++i) {
    handlers::ProgramLocalParameter4fARB(*m_context, kVertex, 0, GLfloat(i), 0, 0, 1);
    ASSERT_TRUE(draw(*m_context));
  }
  EXPECT_TRUE(drawsByAssembly());
}

TEST(ChangePaceTest, ManyDrawsInALittleTimeAreFast) {
  using namespace std::chrono_literals;
  const ChangePace::Clock::time_point start{1h};
  const auto window = ChangePace::kDraws * ChangePace::kApart;
  ChangePace pace;
  EXPECT_FALSE(pace.isFast(start)) << "how long the first took is not known";
  EXPECT_FALSE(pace.isFast(start + window));
  EXPECT_TRUE(pace.isFast(start + 2 * window - 1us));
  EXPECT_FALSE(pace.isFast(start + 3 * window));
  for (unsigned i = 1; i < ChangePace::kDraws; ++i)
    EXPECT_FALSE(pace.isFast());
}

TEST_F(OwnFragments, WhatOnlyGlslDoesIsGlsl) {
  use(*m_context, kFogText);
  EXPECT_TRUE(drawsByAssembly()) << "the host has fog";
  ASSERT_EQ(m_host.assembly.size(), 1u);
  EXPECT_NE(m_host.assembly.begin()->second.find("MOV_SAT result.color"), std::string::npos)
      << "and would have it of colours before they are clamped";
  use(*m_context, "!!ARBfp1.0\nOPTION ARB_fragment_program_shadow;\nTEX result.color, "
                  "fragment.texcoord[0], texture[0], SHADOW2D;\nEND\n");
  EXPECT_TRUE(drawsByGlsl());
  use(*m_context, "!!ARBfp1.0\nMOV result.depth.z, fragment.texcoord[0].x;\nEND\n");
  EXPECT_TRUE(drawsByGlsl());
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  handlers::TexParameteri(*m_context, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                          GL_COMPARE_R_TO_TEXTURE);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(OwnFragments, AReplacementIsGlsl) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  ProgramObject &object = *m_context->row(Target::Fragment).bound;
  auto replaced = std::make_shared<CompiledProgram>(*m_context->group->compiledOf(object));
  replaced->replacement = kShading;
  m_context->group->setCompiled(object, std::move(replaced));
  invalidateProgram(*m_context);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(OwnFragments, WhereTheRasterizerIsForcedItIsGlsl) {
  m_context->software = std::make_unique<ContextState>(*m_context);
  m_context->softwarePossible = m_context->softwareListens = true;
  use(*m_context, kShading);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(OwnFragments, WhatAnotherContextOfTheGroupSetsEndsIt) {
  use(*m_context, kShading);
  ASSERT_TRUE(drawsByAssembly());
  const CurrentContext other(m_host, &*m_context);
  handlers::TexParameteri(*other, GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
  makeCurrent(&*m_context);
  EXPECT_TRUE(drawsByGlsl());
}

TEST_F(OwnFragments, WhatTheHostRefusesIsGlsl) {
  m_host.refusesAssembly = true;
  use(*m_context, kShading);
  EXPECT_TRUE(drawsByGlsl());
  EXPECT_EQ(m_host.error, GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace arbiter::state
