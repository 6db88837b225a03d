// The errors of ARB_fragment_program ("Errors") and of the core rules around it.
#include "fixture.h"

namespace api {
namespace {

using Errors = ApiTest;

TEST_F(Errors, ProgramString) {
  makeProgram(kRed);
  const auto ascii = GLenum(GL_PROGRAM_FORMAT_ASCII_ARB);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glProgramStringARB(GL_TEXTURE_2D, ascii, 4, "text"));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glProgramStringARB(kFragment, GL_RGBA, 4, "text"));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(kBad));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(""));
}

TEST_F(Errors, NegativeLengthIsAnInvalidValue) {
  BARE_HOST_DIFFERS("a negative length is read as a huge one");
  makeProgram(kRed);
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glProgramStringARB(kFragment, GL_PROGRAM_FORMAT_ASCII_ARB, -1, kRed));
}

TEST_F(Errors, FailedLoadKeepsTheOldProgram) {
  makeProgram(kRed);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(kBad));
  glEnable(kFragment);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Errors, BindTakesOneTarget) {
  const GLuint fragment = makeProgram(kRed);
  const GLuint vertex =
      makeProgram("!!ARBvp1.0\nMOV result.position, vertex.position;\nEND", kVertex);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramARB(kVertex, fragment));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramARB(kFragment, vertex));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(fragment)) << "a failed Bind changed it";
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kVertex), GLint(vertex));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindProgramARB(GL_TEXTURE_2D, 0));
}

TEST_F(Errors, GenAndDelete) {
  GLuint name = 0;
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGenProgramsARB(-1, &name));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glDeleteProgramsARB(-1, &name));
  const GLuint unused[] = {0, 987654};
  EXPECT_NO_GL_ERROR(glDeleteProgramsARB(2, unused));
}

TEST_F(Errors, ParameterIndexes) {
  const auto envs = GLuint(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB));
  const auto locals = GLuint(programiv(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB));
  const GLfloat f[4] = {};
  const GLdouble d[4] = {};
  GLfloat fOut[4];
  GLdouble dOut[4];
  EXPECT_NO_GL_ERROR(glProgramEnvParameter4fvARB(kFragment, envs - 1, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4fARB(kFragment, envs, 0, 0, 0, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4fvARB(kFragment, envs, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4dARB(kFragment, envs, 0, 0, 0, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4dvARB(kFragment, envs, d));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetProgramEnvParameterfvARB(kFragment, envs, fOut));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetProgramEnvParameterdvARB(kFragment, envs, dOut));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4fARB(kFragment, locals, 0, 0, 0, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4fvARB(kFragment, locals, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4dARB(kFragment, locals, 0, 0, 0, 0));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4dvARB(kFragment, locals, d));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetProgramLocalParameterfvARB(kFragment, locals, fOut));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetProgramLocalParameterdvARB(kFragment, locals, dOut));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4fvARB(kFragment, 0xFFFFFFFFu, f));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glProgramEnvParameter4fvARB(GL_TEXTURE_2D, 0, f));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glProgramLocalParameter4fvARB(GL_TEXTURE_2D, 0, f));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetProgramEnvParameterfvARB(GL_TEXTURE_2D, 0, fOut));
}

TEST_F(Errors, ParameterRanges) {
  const auto envs = GLuint(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB));
  const GLfloat f[8] = {};
  EXPECT_NO_GL_ERROR(glProgramEnvParameters4fvEXT(kFragment, envs - 2, 2, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameters4fvEXT(kFragment, envs - 1, 2, f));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameters4fvEXT(kFragment, 0, -1, f));
  if (layered()) { // the bare host's check overflows and it writes out of bounds
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameters4fvEXT(kFragment, 0xFFFFFFFFu, 2, f));
  }
}

TEST_F(Errors, Getters) {
  GLint value = 0;
  char text[8];
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetProgramivARB(GL_TEXTURE_2D, GL_PROGRAM_LENGTH_ARB, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetProgramivARB(kFragment, GL_TEXTURE_2D, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetProgramStringARB(kFragment, GL_TEXTURE_2D, text));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetProgramStringARB(GL_RGBA, GL_PROGRAM_STRING_ARB, text));
}

TEST_F(Errors, EverythingIsAnErrorBetweenBeginAndEnd) {
  const GLuint program = makeProgram(kRed);
  GLuint name = 0;
  GLint value = 0;
  const GLfloat f[4] = {};
  GLfloat fOut[4];
  char text[64];
  const auto between = [](auto &&call) {
    glBegin(GL_POINTS);
    call();
    glEnd();
    return glGetError();
  };
  const auto error = GLenum(GL_INVALID_OPERATION);
  EXPECT_EQ(between([&] { load(kRed); }), error);
  EXPECT_EQ(between([&] { glBindProgramARB(kFragment, program); }), error);
  EXPECT_EQ(between([&] { glGenProgramsARB(1, &name); }), error);
  EXPECT_EQ(between([&] { glDeleteProgramsARB(1, &program); }), error);
  EXPECT_EQ(between([&] { glEnable(kFragment); }), error);
  EXPECT_EQ(between([&] { glDisable(kFragment); }), error);
  EXPECT_EQ(between([&] { glIsEnabled(kFragment); }), error);
  EXPECT_EQ(between([&] { glGetProgramivARB(kFragment, GL_PROGRAM_LENGTH_ARB, &value); }), error);
  EXPECT_EQ(between([&] { glGetProgramStringARB(kFragment, GL_PROGRAM_STRING_ARB, text); }), error);
  EXPECT_EQ(between([&] { glGetProgramEnvParameterfvARB(kFragment, 0, fOut); }), error);
  EXPECT_EQ(between([&] { glGetProgramLocalParameterfvARB(kFragment, 0, fOut); }), error);
  EXPECT_EQ(between([&] { glProgramEnvParameter4fvARB(kFragment, 0, f); }), error);
  EXPECT_EQ(between([&] { glProgramLocalParameter4fvARB(kFragment, 0, f); }), error);
  EXPECT_EQ(between([&] { glPushAttrib(GL_ENABLE_BIT); }), error);
  EXPECT_TRUE(glIsProgramARB(program)) << "an erroneous Delete deleted it";
  EXPECT_FALSE(glIsEnabled(kFragment)) << "an erroneous Enable enabled it";
}

TEST_F(Errors, TheFirstErrorWins) {
  makeProgram(kRed);
  glEnable(GL_LINE_LOOP); // raises the host's INVALID_ENUM
  load(kBad);             // raises the layer's error
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  load(kBad); // raises the layer's error first
  glEnable(GL_LINE_LOOP);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(Errors, AnInvalidProgramForbidsDrawing) {
  glEnable(kFragment); // object 0 holds no program
  clear();
  glColor4f(0, 0, 1, 1);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBegin(GL_QUADS); glEnd());
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDrawArrays(GL_TRIANGLES, 0, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glRectf(-1, -1, 1, 1));
  if (layered()) { // the bare host raises nothing
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glRasterPos2f(0, 0));
  }
  const GLubyte pixel[4] = {255, 255, 255, 255};
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glCopyPixels(0, 0, 1, 1, GL_COLOR));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBitmap(8, 1, 0, 0, 0, 0, pixel));
  EXPECT_EQ(readPixel(), kBlack) << "a forbidden draw drew";
  makeProgram(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
  glBindProgramARB(kFragment, 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, drawQuad());
  glDisable(kFragment);
  EXPECT_EQ(drawn(), kBluePixel);
}

} // namespace
} // namespace api
