/// The entry points of program commands that decide before a handler is called: which of them the
/// layer refuses or passes on, and the commands whose values are converted.
#include <array>

#include <gtest/gtest.h>

#include "dispatch/entry_points.h"
#include "state/testing/nv_context.h"

namespace arbiter::dispatch {
namespace {

using namespace state::testing;
using state::Context;
using state::Vec4;

template <typename Function> Function *entry(const char *name) {
  return reinterpret_cast<Function *>(find(name).function);
}

/// Calls the forms 4d, 4dv and 4fv of a command, whose first arguments are `leading`, with values
/// that differ.
template <typename Read, typename... Leading>
void expectForms(const std::string &name, const std::string &suffix, const Read &read,
                 Leading... leading) {
  const auto of = [&](const char *form) { return "gl" + name + form + suffix; };
  using Doubles = void(Leading..., GLdouble, GLdouble, GLdouble, GLdouble);
  entry<Doubles>(of("4d").c_str())(leading..., 4, 3, 2, 1);
  EXPECT_EQ(read(), (Vec4{4, 3, 2, 1})) << of("4d");
  const std::array<GLdouble, 4> doubles = {1, 2, 3, 4};
  entry<void(Leading..., const GLdouble *)>(of("4dv").c_str())(leading..., doubles.data());
  EXPECT_EQ(read(), (Vec4{1, 2, 3, 4})) << of("4dv");
  const std::array<GLfloat, 4> floats = {9, 7, 5, 3};
  entry<void(Leading..., const GLfloat *)>(of("4fv").c_str())(leading..., floats.data());
  EXPECT_EQ(read(), (Vec4{9, 7, 5, 3})) << of("4fv");
}

TEST(ProgramCommands, EachFormOfAParameterSetsTheSame) {
  NvHost host;
  const CurrentContext context(host);
  Vec4 value{};
  const GLuint name = use(*context, kPlacingText, kVertex);
  const auto env = [&] {
    state::handlers::GetProgramEnvParameterfvARB(*context, kVertex, 2, value.data());
    return value;
  };
  const auto local = [&] {
    state::handlers::GetProgramLocalParameterfvARB(*context, kVertex, 3, value.data());
    return value;
  };
  expectForms("ProgramEnvParameter", "ARB", env, kVertex, GLuint(2));
  expectForms("ProgramLocalParameter", "ARB", local, kVertex, GLuint(3));
  expectForms("NamedProgramLocalParameter", "EXT", local, name, kVertex, GLuint(3));
  expectForms("ProgramParameter", "NV", env, kNvVertex, GLuint(2));
  loadNv(*context, kNvFragment, 103, kFp);
  const auto *const blue = reinterpret_cast<const GLubyte *>("blue");
  const auto named = [&] {
    state::handlers::GetProgramNamedParameterfvNV(*context, 103, 4, blue, value.data());
    return value;
  };
  expectForms("ProgramNamedParameter", "NV", named, GLuint(103), GLsizei(4), blue);
  EXPECT_EQ(error(*context), kNoError);
}

/// Calls the forms 4dv and 4fv of a command with a pointer that cannot be read.
template <typename... Leading>
void expectUnread(Context &context, const std::string &name, const std::string &suffix,
                  GLenum fault, Leading... leading) {
  const auto of = [&](const char *form) { return "gl" + name + form + suffix; };
  entry<void(Leading..., const GLdouble *)>(of("4dv").c_str())(leading..., nullptr);
  EXPECT_EQ(error(context), fault) << of("4dv");
  entry<void(Leading..., const GLfloat *)>(of("4fv").c_str())(leading..., nullptr);
  EXPECT_EQ(error(context), fault) << of("4fv");
}

TEST(ProgramCommands, ValuesOfACommandThatIsAnErrorAreNotRead) {
  NvHost host;
  const CurrentContext context(host);
  constexpr GLuint kFar = 1u << 30;
  const GLuint name = use(*context, kPlacingText, kVertex);
  expectUnread(*context, "ProgramEnvParameter", "ARB", kValue, kVertex, kFar);
  expectUnread(*context, "ProgramLocalParameter", "ARB", kValue, kVertex, kFar);
  expectUnread(*context, "NamedProgramLocalParameter", "EXT", kValue, name, kVertex, kFar);
  expectUnread(*context, "ProgramParameter", "NV", kValue, kNvVertex, kFar);
  expectUnread(*context, "ProgramParameter", "NV", kEnum, kNvFragment, GLuint(0));
  const auto *const blue = reinterpret_cast<const GLubyte *>("blue");
  expectUnread(*context, "ProgramNamedParameter", "NV", kOperation, GLuint(77), GLsizei(4), blue);
}

const void *g_passed = nullptr;
void hostEnvFloats(GLenum, GLuint, const GLfloat *values) { g_passed = values; }
void hostLocalDoubles(GLenum, GLuint, const GLdouble *values) { g_passed = values; }
void hostNamedFloats(GLuint, GLenum, GLuint, const GLfloat *values) { g_passed = values; }

/// A target that the layer does not know is the host's to judge, and so is the pointer.
TEST(ProgramCommands, ValuesForATargetOfTheHostsAreTheHostsToRead) {
  NvHost host;
  const CurrentContext context(host);
  host::HostTable table = *host.table();
  table.ProgramEnvParameter4fvARB = hostEnvFloats;
  table.ProgramLocalParameter4dvARB = hostLocalDoubles;
  table.NamedProgramLocalParameter4fvEXT = hostNamedFloats;
  context->host = &table;
  const auto passes = [](const auto &call, const auto *values) {
    g_passed = nullptr;
    call(values);
    EXPECT_EQ(g_passed, values);
  };
  const auto *const nowhere = reinterpret_cast<const GLfloat *>(8);
  constexpr GLenum kOther = GL_TEXTURE_2D;
  passes(
      [](const GLfloat *at) {
        entry<void(GLenum, GLuint, const GLfloat *)>("glProgramEnvParameter4fvARB")(kOther, 0, at);
      },
      nowhere);
  passes(
      [](const GLdouble *at) {
        entry<void(GLenum, GLuint, const GLdouble *)>("glProgramLocalParameter4dvARB")(kOther, 0,
                                                                                       at);
      },
      reinterpret_cast<const GLdouble *>(nowhere));
  passes(
      [](const GLfloat *at) {
        using Named = void(GLuint, GLenum, GLuint, const GLfloat *);
        entry<Named>("glNamedProgramLocalParameter4fvEXT")(1, kOther, 0, at);
      },
      nowhere);
  context->host = host.table();
}

int g_loads = 0;
void hostLoadProgram(GLenum, GLuint, GLsizei, const GLubyte *) { ++g_loads; }
GLboolean hostAreResident(GLsizei, const GLuint *, GLboolean *) {
  ++g_loads;
  return GL_TRUE;
}
int g_attributes = 0;
void hostAttribute(GLuint, GLfloat) { ++g_attributes; }

/// Its GLSL lacks features that NVIDIA's languages need.
class WithoutNvLanguages : public testing::Test {
protected:
  WithoutNvLanguages() : m_context(m_host) {
    m_table = *m_host.table();
    m_table.LoadProgramNV = hostLoadProgram;
    m_table.AreProgramsResidentNV = hostAreResident;
    m_table.VertexAttrib1fNV = hostAttribute;
    m_context->host = &m_table;
    g_loads = g_attributes = 0;
  }
  ~WithoutNvLanguages() override { m_context->host = m_host.table(); }

  void loads() {
    using Load = void(GLenum, GLuint, GLsizei, const GLubyte *);
    entry<Load>("glLoadProgramNV")(kNvVertex, 101, GLsizei(kVp.size()),
                                   reinterpret_cast<const GLubyte *>(kVp.data()));
  }
  GLboolean resident() {
    using Resident = GLboolean(GLsizei, const GLuint *, GLboolean *);
    const GLuint name = 101;
    GLboolean residence = GL_FALSE;
    return entry<Resident>("glAreProgramsResidentNV")(1, &name, &residence);
  }

  FakeHost m_host;
  host::HostTable m_table;
  CurrentContext m_context;
};

TEST_F(WithoutNvLanguages, TheirCommandsAreErrors) {
  ASSERT_FALSE(m_context->nv);
  loads();
  EXPECT_EQ(error(*m_context), kOperation);
  EXPECT_EQ(resident(), GL_FALSE);
  EXPECT_EQ(error(*m_context), kOperation);
  EXPECT_EQ(g_loads, 0);
}

TEST_F(WithoutNvLanguages, TheirCommandsAreTheHostsIfItDrawsAllPrograms) {
  m_context->offered = false;
  loads();
  EXPECT_EQ(resident(), GL_TRUE);
  EXPECT_EQ(g_loads, 2);
  EXPECT_EQ(error(*m_context), kNoError);
}

TEST_F(WithoutNvLanguages, AttributesAreTheHosts) {
  entry<void(GLuint, GLfloat)>("glVertexAttrib1fNV")(1, 2.0f);
  EXPECT_EQ(g_attributes, 1);
  EXPECT_EQ(error(*m_context), kNoError);
}

} // namespace
} // namespace arbiter::dispatch
