// The vertex target of the program API: objects, parameters, counts, limits, errors, enables,
// lists. State that it shares with the fragment target is tested if the two could be confused.
#include <cstring>

#include "fixture.h"

namespace api {
namespace {

constexpr char kPlain[] = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                          "MOV result.color, vertex.color;\nEND";

using VertexQueries = ApiTest;

TEST_F(VertexQueries, AnObjectHasOneTarget) {
  const GLuint vertex = makeProgram(kPlain, kVertex);
  EXPECT_TRUE(glIsProgramARB(vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), GLint(vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kFragment), 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramARB(kFragment, vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), GLint(vertex));
  const GLuint fragment = makeProgram(kRed);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramARB(kVertex, fragment));
  glDeleteProgramsARB(1, &vertex);
  EXPECT_FALSE(glIsProgramARB(vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), 0);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kFragment), GLint(fragment));
  glBindProgramARB(kFragment, vertex); // either target may use the name
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(VertexQueries, TheAliasesOfNvAreTheSameCalls) {
  using Gen = void (*)(GLsizei, GLuint *);
  using Bind = void (*)(GLenum, GLuint);
  using Is = GLboolean (*)(GLuint);
  const auto gen = reinterpret_cast<Gen>(eglGetProcAddress("glGenProgramsNV"));
  const auto bind = reinterpret_cast<Bind>(eglGetProcAddress("glBindProgramNV"));
  const auto is = reinterpret_cast<Is>(eglGetProcAddress("glIsProgramNV"));
  ASSERT_TRUE(gen && bind && is); // libglvnd has a stub for every name
  GLuint name = 0;
  gen(1, &name);
  bind(kVertex, name);
  const bool works = glGetError() == GL_NO_ERROR && name != 0;
  if (!works && !layered())
    GTEST_SKIP() << "GL_NV_vertex_program is not offered here";
  ASSERT_TRUE(works);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), GLint(name));
  EXPECT_TRUE(is(name));
}

TEST_F(VertexQueries, AWrongTextIsRefusedAndTheOldOneStays) {
  makeProgram(kPlain, kVertex);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load("!!ARBvp1.0 MOV result.color, nothing; END", kVertex));
  EXPECT_GE(integer(GL_PROGRAM_ERROR_POSITION_ARB), 0);
  if (layered()) {
    EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), 29);
  }
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB, kVertex), GLint(std::strlen(kPlain)));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(kRed, kVertex)); // the other target's language
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(kPlain, kFragment));
  char text[sizeof kPlain] = {};
  glGetProgramStringARB(kVertex, GL_PROGRAM_STRING_ARB, text);
  EXPECT_STREQ(text, kPlain);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glProgramStringARB(kVertex, 0, 0, ""));
}

TEST_F(VertexQueries, ParametersAreTheTargetsOwn) {
  const GLuint first = makeProgram(kPlain, kVertex);
  const GLfloat f[8] = {1, -2, 0.5f, 4, 5, 6, 7, 8};
  glProgramEnvParameter4fvARB(kVertex, 3, f);
  glProgramEnvParameter4dARB(kVertex, 95, 0.25, 1, 2, 3);
  glProgramLocalParameters4fvEXT(kVertex, 1, 2, f);
  GLfloat out[4] = {};
  GLdouble dOut[4] = {};
  glGetProgramEnvParameterfvARB(kVertex, 3, out);
  EXPECT_EQ(out[1], -2.0f);
  glGetProgramEnvParameterdvARB(kVertex, 95, dOut);
  EXPECT_EQ(dOut[0], 0.25);
  glGetProgramLocalParameterfvARB(kVertex, 2, out);
  EXPECT_EQ(out[3], 8.0f);
  glGetProgramEnvParameterfvARB(kFragment, 3, out);
  EXPECT_EQ(out[1], 0.0f);
  glGetProgramLocalParameterfvARB(kFragment, 2, out);
  EXPECT_EQ(out[3], 0.0f);
  makeProgram(kPlain, kVertex);
  glGetProgramLocalParameterfvARB(kVertex, 2, out);
  EXPECT_EQ(out[3], 0.0f);
  glBindProgramARB(kVertex, first);
  glGetProgramLocalParameterfvARB(kVertex, 2, out);
  EXPECT_EQ(out[3], 8.0f);
  const auto env = GLuint(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB, kVertex));
  const auto local = GLuint(programiv(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB, kVertex));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4fvARB(kVertex, env, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4fvARB(kVertex, local, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameters4fvEXT(kVertex, env - 1, 2, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetProgramLocalParameterfvARB(kVertex, local, out));
}

TEST_F(VertexQueries, LimitsAreAtLeastTheSpecifications) {
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB, kVertex), 96);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB, kVertex), 96);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_INSTRUCTIONS_ARB, kVertex), 128);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_TEMPORARIES_ARB, kVertex), 12);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_PARAMETERS_ARB, kVertex), 96);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ATTRIBS_ARB, kVertex), 16);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB, kVertex), 1);
  EXPECT_EQ(integer(GL_MAX_VERTEX_ATTRIBS_ARB), 16);
}

TEST_F(VertexQueries, CountsAreComputed) {
  BARE_HOST_DIFFERS("END is counted");
  makeProgram("!!ARBvp1.0\n"
              "ADDRESS a;\n"
              "TEMP t, unused;\n"
              "PARAM rows[4] = { program.env[0..3] };\n"
              "ARL a.x, vertex.attrib[1].x;\n"
              "ADD t, rows[a.x], vertex.position;\n"
              "MOV result.position, t;\n"
              "MOV result.color, program.local[1];\n"
              "END",
              kVertex);
  EXPECT_EQ(programiv(GL_PROGRAM_INSTRUCTIONS_ARB, kVertex), 4);
  EXPECT_EQ(programiv(GL_PROGRAM_TEMPORARIES_ARB, kVertex), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_PARAMETERS_ARB, kVertex), 5);
  EXPECT_EQ(programiv(GL_PROGRAM_ATTRIBS_ARB, kVertex), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_ADDRESS_REGISTERS_ARB, kVertex), 1);
  EXPECT_EQ(programiv(GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB, kVertex), 1);
  EXPECT_EQ(programiv(GL_PROGRAM_ADDRESS_REGISTERS_ARB, kFragment), 0);
}

TEST_F(VertexQueries, EnableAndAttributeStack) {
  glEnable(kVertex);
  EXPECT_TRUE(glIsEnabled(kVertex));
  EXPECT_FALSE(glIsEnabled(kFragment));
  EXPECT_EQ(integer(kVertex), 1);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kVertex);
  glEnable(kFragment);
  glPopAttrib();
  EXPECT_TRUE(glIsEnabled(kVertex));
  EXPECT_FALSE(glIsEnabled(kFragment));
  glDisable(kVertex);
}

TEST_F(VertexQueries, AnInvalidProgramStopsVerticesAndRasterPos) {
  EXPECT_NO_GL_ERROR(drawQuad());
  glEnable(kVertex);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBegin(GL_POINTS));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glRectf(0, 0, 1, 1));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDrawArrays(GL_POINTS, 0, 1));
  if (layered()) { // the bare host raises nothing
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glRasterPos2f(0, 0));
  }
  makeProgram(kPlain, kVertex);
  EXPECT_NO_GL_ERROR(glRasterPos2f(0, 0));
  EXPECT_NO_GL_ERROR(drawQuad());
  glDisable(kVertex);
}

TEST_F(VertexQueries, AnInvalidProgramDoesNotStopPixels) {
  const GLubyte green[4] = {0, 255, 0, 255};
  glRasterPos2f(-1, -1);
  glPixelZoom(32, 32);
  clear();
  glEnable(kVertex);
  EXPECT_NO_GL_ERROR(glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green));
  EXPECT_EQ(readPixel(), kGreenPixel) << "no vertex is transformed";
  EXPECT_NO_GL_ERROR(glWindowPos2f(0, 0));
  EXPECT_NO_GL_ERROR(glBitmap(0, 0, 0, 0, 1, 1, nullptr));
  glPixelZoom(1, 1);
  glDisable(kVertex);
}

TEST_F(VertexQueries, CommandsBetweenBeginAndEndAreErrors) {
  const GLuint name = makeProgram(kPlain, kVertex);
  glBegin(GL_POINTS);
  glBindProgramARB(kVertex, name);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  glBegin(GL_POINTS);
  glProgramStringARB(kVertex, GL_PROGRAM_FORMAT_ASCII_ARB, 3, "END");
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB, kVertex), GLint(std::strlen(kPlain)));
}

TEST_F(VertexQueries, ListsHoldTheCommandsOfTheirTarget) {
  const GLuint vertex = makeProgram(kPlain, kVertex);
  const GLuint fragment = makeProgram(kRed);
  glBindProgramARB(kVertex, 0);
  glBindProgramARB(kFragment, 0);
  glNewList(1, GL_COMPILE);
  glBindProgramARB(kVertex, vertex);
  glProgramEnvParameter4fARB(kVertex, 0, 1, 2, 3, 4);
  glProgramLocalParameter4fARB(kVertex, 2, 5, 6, 7, 8);
  glEnable(kVertex);
  glEndList();
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), 0) << "COMPILE executed";
  glCallList(1);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), GLint(vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kFragment), 0);
  EXPECT_TRUE(glIsEnabled(kVertex));
  EXPECT_FALSE(glIsEnabled(kFragment));
  GLfloat value[4] = {};
  glGetProgramEnvParameterfvARB(kVertex, 0, value);
  EXPECT_EQ(value[1], 2.0f);
  glGetProgramLocalParameterfvARB(kVertex, 2, value);
  EXPECT_EQ(value[1], 6.0f);
  glGetProgramEnvParameterfvARB(kFragment, 0, value);
  EXPECT_EQ(value[1], 0.0f);
  glDisable(kVertex);
  glDeleteLists(1, 1);
  glDeleteProgramsARB(1, &fragment);
}

TEST_F(VertexQueries, ByName) {
  NEEDS("GL_EXT_direct_state_access");
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glNamedProgramStringEXT(name, kVertex, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(kPlain)),
                          kPlain);
  glNamedProgramLocalParameter4fEXT(name, kVertex, 0, 0, 1, 0, 1);
  GLfloat value[4] = {};
  glGetNamedProgramLocalParameterfvEXT(name, kVertex, 0, value);
  EXPECT_EQ(value[1], 1.0f);
  GLint length = 0;
  glGetNamedProgramivEXT(name, kVertex, GL_PROGRAM_LENGTH_ARB, &length);
  EXPECT_EQ(length, GLint(std::strlen(kPlain)));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), 0) << "nothing was bound";
}

} // namespace
} // namespace api
