/// The generated entry points: which calls they pass on, what they count, and the table of their
/// names.
#include <cstdint>

#include <gtest/gtest.h>

#include "dispatch/entry_points.h"
#include "host/host_table.h"
#include "state/context/context.h"

namespace arbiter::dispatch {
namespace {

int g_calls = 0;
void hostDrawArrays(GLenum mode, GLint first, GLsizei count) {
  g_calls += mode == GL_POINTS && first == 3 && count == 7 ? 1 : 100;
}
void hostUniform4fv(GLint location, GLsizei count, const GLfloat *value) {
  g_calls += location == 2 && count == 1 && value[3] == 4.0f ? 1 : 100;
}
void hostRasterPos2f(GLfloat x, GLfloat y) { g_calls += x == 1.5f && y == 2.5f ? 1 : 100; }

/// Runs each test with a current context that has no work for any call.
class EntryPoints : public testing::Test {
protected:
  void SetUp() override {
    g_calls = 0;
    m_table.DrawArrays = hostDrawArrays;
    m_table.Uniform4fv = hostUniform4fv;
    m_table.RasterPos2f = hostRasterPos2f;
    m_hot.host = &m_table;
    m_hot.drawCounter = &m_draws;
    m_before = state::t_current;
    state::t_current = &m_hot;
  }
  void TearDown() override { state::t_current = m_before; }

  template <typename Function> Function *entry(Function *, const char *name) {
    return reinterpret_cast<Function *>(find(name).function);
  }

  host::HostTable m_table;
  state::ContextHot m_hot;
  state::ContextHot *m_before = nullptr;
  Counter m_draws;
};

TEST_F(EntryPoints, ADrawIsCountedAndPassedOn) {
  entry(hostDrawArrays, "glDrawArrays")(GL_POINTS, 3, 7);
  entry(hostDrawArrays, "glDrawArraysEXT")(GL_POINTS, 3, 7);
  EXPECT_EQ(g_calls, 2);
  EXPECT_EQ(m_draws, 2u);
}

TEST_F(EntryPoints, AnObserverPassesOn) {
  const GLfloat value[4] = {1, 2, 3, 4};
  entry(hostUniform4fv, "glUniform4fvARB")(2, 1, value);
  EXPECT_EQ(g_calls, 1);
  EXPECT_EQ(m_draws, 0u);
}

TEST_F(EntryPoints, AValidatorPassesOnAndCountsNothing) {
  entry(hostRasterPos2f, "glRasterPos2f")(1.5f, 2.5f);
  EXPECT_EQ(g_calls, 1);
  EXPECT_EQ(m_draws, 0u);
}

TEST(EntryTable, HasEachNameOfAnAliasGroup) {
  EXPECT_NE(find("glDrawArrays").function, nullptr);
  EXPECT_EQ(find("glDrawArrays").function, find("glDrawArraysEXT").function);
  EXPECT_EQ(find("glUseProgram").function, find("glUseProgramObjectARB").function);
  EXPECT_EQ(find("glGenProgramsARB").function, find("glGenProgramsNV").function);
  EXPECT_NE(find("glBindProgramARB").function, find("glBindProgramNV").function)
      << "their errors differ";
  EXPECT_TRUE(find("glProgramStringARB").provided);
  EXPECT_FALSE(find("glDrawArrays").provided);
}

TEST(EntryTable, HasTheLayersOwnWithoutASuffix) {
  EXPECT_EQ(find("glCombinerInput").function, find("glCombinerInputNV").function);
  EXPECT_EQ(find("glBeginFragmentShader").function, find("glBeginFragmentShaderATI").function);
  EXPECT_EQ(find("glProgramEnvParameter4f").function, find("glProgramEnvParameter4fARB").function);
  EXPECT_TRUE(find("glCombinerInput").provided);
  EXPECT_NE(find("glGetProgramiv").function, find("glGetProgramivARB").function)
      << "GL has another function of this name";
}

TEST(EntryTable, HasNothingElse) {
  for (const char *name : {"glProgramBufferParametersfvNV", "glPNTrianglesfATI", "glVertex3f",
                           "glBlendFunc", "", "gl", "glzzz"})
    EXPECT_EQ(find(name).function, nullptr) << name;
}

TEST(EntryTable, TellsWhatIsThereForTheRasterizerAlone) {
  EXPECT_TRUE(find("glClear").forSoftware);
  EXPECT_FALSE(find("glDrawArrays").forSoftware);
  EXPECT_NE(findForSoftware("glVertex3f").function, nullptr);
  EXPECT_NE(findForSoftware("glVertexAttrib4f").function,
            findForSoftware("glVertexAttrib4fNV").function);
  EXPECT_EQ(findForSoftware("glBlendFunciARB").function, findForSoftware("glBlendFunci").function);
  EXPECT_NE(findForSoftware("glClearColor").function, nullptr) << "it may be compiled into a list";
  // The host's functions serve these: they are intercepted otherwise, never compiled into lists, or
  // belong to OpenGL ES only.
  for (const char *name : {"glDrawArrays", "glClear", "glGetShaderSource", "glIsTexture",
                           "glDrawTexfOES", "", "glzzz"})
    EXPECT_EQ(findForSoftware(name).function, nullptr) << name;
}

TEST(EntryTable, KnowsItsOwn) {
  EXPECT_TRUE(isOurs(find("glEnable").function));
  EXPECT_TRUE(isOurs(findForSoftware("glBlendFunc").function));
  EXPECT_FALSE(isOurs(reinterpret_cast<const void *>(&hostDrawArrays)));
  EXPECT_FALSE(isOurs(nullptr));
}

} // namespace
} // namespace arbiter::dispatch
