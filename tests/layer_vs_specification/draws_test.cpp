// Tests draws: parameters, precedence over GLSL, pixel paths, the invisible host program.
#include <vector>

#include "fixture.h"

namespace api {
namespace {

class Draws : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glEnable(kFragment);
  }
};

TEST_F(Draws, ParametersReachTheProgram) {
  makeProgram(kEnv0);
  EXPECT_EQ(drawn(), kBlack) << "initially zero";
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  const GLuint first = makeProgram(kLocal0);
  glProgramLocalParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  makeProgram(kLocal0); // the same text with its own parameters
  glProgramLocalParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glBindProgramARB(kFragment, first);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Draws, ManyParametersWithGaps) {
  std::string text = "!!ARBfp1.0\nTEMP s;\nMOV s, 0;\n";
  for (int i = 0; i < 20; i += 2)
    text += "ADD s, s, program.env[" + std::to_string(i) + "];\n";
  text += "MOV result.color, s;\nEND";
  makeProgram(text);
  for (GLuint i = 0; i < 20; ++i)
    glProgramEnvParameter4fARB(kFragment, i, i % 2 ? 100.0f : 0.0f, i == 8, 0, i == 18);
  EXPECT_EQ(drawn(), kGreenPixel);
  glProgramEnvParameter4fARB(kFragment, 2, 1, -1, 0, 0);
  glProgramEnvParameter4fARB(kFragment, 16, 0, 0, 0, 0);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Draws, ReloadingTheBoundProgram) {
  makeProgram(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
  load(kGreen);
  EXPECT_EQ(drawn(), kGreenPixel);
  load(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Draws, DeletedWhileBoundInItsContext) {
  const GLuint name = makeProgram(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
  glDeleteProgramsARB(1, &name);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, drawQuad());
  glBindProgramARB(kFragment, name); // a new object
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB), 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, drawQuad());
  load(kGreen);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(Draws, GlslVerticesAloneFeedTheArbProgram) {
  makeProgram(kEnv0);
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  const GLuint vertices = makeGlsl(
      "void main() { gl_Position = gl_Vertex; gl_FrontColor = vec4(0, 0, 1, 1); }", nullptr);
  glUseProgram(vertices);
  EXPECT_EQ(drawn(), kRedPixel);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  makeProgram(kRed);
  EXPECT_EQ(drawn(), kRedPixel) << "another effective program";
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  EXPECT_EQ(drawn(), kBluePixel) << "fixed-function fragments";
  glPopAttrib();
  EXPECT_EQ(drawn(), kRedPixel);
  glDisable(kFragment);
  glPushAttrib(GL_ENABLE_BIT);
  glPopAttrib();
  EXPECT_EQ(drawn(), kBluePixel) << "the host's enable came back with the stack";
  glEnable(kFragment);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kRedPixel);
  makeProgram(kBad);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  glUseProgram(vertices);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, drawQuad());
  glUseProgram(0);
  glDeleteProgram(vertices);
}

TEST_F(Draws, TheApplicationsGlslWins) {
  makeProgram(kRed);
  const GLuint glsl = makeGlsl("void main() { gl_Position = gl_Vertex; }",
                               "void main() { gl_FragColor = vec4(0, 1, 0, 1); }");
  EXPECT_EQ(drawn(), kRedPixel);
  glUseProgram(glsl);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), GLint(glsl));
  EXPECT_EQ(drawn(), kGreenPixel);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kRedPixel);
  glDisable(kFragment);
  EXPECT_EQ(drawn(), kBluePixel);
  glUseProgram(glsl);
  EXPECT_EQ(drawn(), kGreenPixel);
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glUseProgram(0xABCDEF));
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), GLint(glsl));
}

TEST_F(Draws, NothingOfTheHostProgramShows) {
  makeProgram(kEnv0);
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glUniform4f(0, 0, 1, 0, 1));
  EXPECT_EQ(drawn(), kRedPixel) << "an application's glUniform reached the layer's program";
  for (GLuint name = 1; name < 64; ++name)
    EXPECT_FALSE(glIsProgram(name) || glIsShader(name)) << name;
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glUseProgram(0xABCDEF));
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0);
  EXPECT_EQ(drawn(), kRedPixel) << "after a UseProgram that failed";
}

TEST_F(Draws, VertexProgramsFeedFragmentPrograms) {
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[2];\nEND");
  makeProgram("!!ARBvp1.0\nMOV result.position, vertex.attrib[0];\n"
              "MOV result.texcoord[2], vertex.attrib[6];\nEND",
              kVertex);
  glEnable(kVertex);
  glVertexAttrib4fARB(6, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDisable(kVertex);
}

TEST_F(Draws, GlslVerticesWithAFragmentProgram) {
  makeProgram("!!ARBfp1.0\nADD result.color, fragment.texcoord[1], program.env[0];\nEND");
  glProgramEnvParameter4fARB(kFragment, 0, 0, 0, 0, 1);
  const GLuint glsl = makeGlsl("uniform vec4 tint[2];\n"
                               "uniform int which;\n"
                               "attribute vec4 scale;\n"
                               "void main() { gl_Position = gl_Vertex;\n"
                               "  gl_TexCoord[1] = tint[which] * scale; }",
                               nullptr);
  glUseProgram(glsl);
  const GLint tint = glGetUniformLocation(glsl, "tint[0]");
  const GLint second = glGetUniformLocation(glsl, "tint[1]");
  const GLint which = glGetUniformLocation(glsl, "which");
  const GLint scale = glGetAttribLocation(glsl, "scale");
  ASSERT_GE(scale, 0);
  glVertexAttrib4f(GLuint(scale), 1, 1, 1, 0);
  glUniform4f(tint, 1, 0, 0, 0);
  glUniform4f(second, 0, 1, 0, 0);
  EXPECT_EQ(drawn(), kRedPixel);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), GLint(glsl));
  glUniform1i(which, 1);
  EXPECT_EQ(drawn(), kGreenPixel) << "a uniform set between draws";
  GLfloat value[4] = {};
  glGetUniformfv(glsl, tint, value);
  EXPECT_EQ(value[0], 1.0f);
  glDisable(kFragment);
  clear();
  drawQuad();
  glEnable(kFragment);
  glUseProgram(0);
  load(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
  glUseProgram(glsl);
  glLinkProgram(glsl); // uniforms are zero again
  load("!!ARBfp1.0\nADD result.color, fragment.texcoord[1], program.env[0];\nEND");
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDeleteProgram(glsl);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), GLint(glsl)) << "deleted while current: it stays";
  EXPECT_EQ(drawn(), kGreenPixel);
  glUseProgram(0);
  EXPECT_FALSE(glIsProgram(glsl));
}

TEST_F(Draws, GlslVerticesAcrossTheAttributeStack) {
  makeProgram(kRed);
  glUseProgram(makeGlsl("void main() { gl_Position = gl_Vertex; }", nullptr));
  EXPECT_EQ(drawn(), kRedPixel);
  int known = 0;
  for (GLuint name = 1; name < 64; ++name)
    known += glIsProgramARB(name);
  EXPECT_EQ(known, 1) << "a program object that is not the application's shows";
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  EXPECT_EQ(drawn(), kRedPixel);
  glPopAttrib();
  EXPECT_EQ(drawn(), kRedPixel) << "PopAttrib restored the host's own enable";
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kBluePixel);
  glPopAttrib();
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Draws, VertexArrays) {
  makeProgram(kRed);
  const GLfloat corners[] = {-1, -1, 1, -1, 1, 1, -1, 1};
  const GLubyte indexes[] = {0, 1, 2, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kRedPixel);
  load(kGreen);
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indexes);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glDisableClientState(GL_VERTEX_ARRAY);
}

TEST_F(Draws, PixelPaths) {
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.color.gbra;\nEND");
  const GLubyte blue[4] = {0, 0, 255, 255};
  clear();
  glColor4f(0, 0, 1, 1);
  glRasterPos2f(-1, -1);
  glPixelZoom(32, 32);
  glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, blue);
  EXPECT_EQ(readPixel(), kGreenPixel) << "DrawPixels";
  glPixelZoom(1, 1);
  glCopyPixels(0, 0, 32, 32, GL_COLOR);
  EXPECT_EQ(readPixel(), kRedPixel) << "CopyPixels of green, rotated once more";
  clear();
  std::vector<GLubyte> ones(4 * 32, 0xFF);
  glBitmap(32, 32, 0, 0, 0, 0, ones.data());
  EXPECT_EQ(readPixel(), kGreenPixel) << "Bitmap in the raster colour";
}

TEST_F(Draws, StateThatChangesBetweenDraws) {
  makeProgram("!!ARBfp1.0\nMOV result.color, state.matrix.program[0].row[1];\nEND");
  glMatrixMode(GL_MATRIX0_ARB);
  const GLfloat red[16] = {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
  const GLfloat green[16] = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
  glLoadMatrixf(red);
  EXPECT_EQ(drawn(), kRedPixel);
  glLoadMatrixf(green);
  EXPECT_EQ(drawn(), kGreenPixel);
  glMatrixMode(GL_MODELVIEW);
  load("!!ARBfp1.0\nMOV result.color, state.texenv[1].color;\nEND");
  const GLfloat color[4] = {1, 0, 0, 1};
  glActiveTexture(GL_TEXTURE1);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
  glActiveTexture(GL_TEXTURE3);
  EXPECT_EQ(drawn(), kRedPixel);
  EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE3);
  glActiveTexture(GL_TEXTURE0);
}

class Compare : public Draws {
protected:
  void SetUp() override {
    Draws::SetUp();
    glGenTextures(1, &m_texture);
    glBindTexture(GL_TEXTURE_2D, m_texture);
    const GLfloat half = 0.5f;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 &half);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
  }
  GLuint m_texture = 0;
};

TEST_F(Compare, APlainTargetDoesNotCompare) {
  BARE_HOST_DIFFERS("llvmpipe compares all the same");
  makeProgram("!!ARBfp1.0\nTEMP t;\nTEX t, {0.5,0.5,0.25,1}, texture[0], 2D;\n"
              "MOV result.color, t;\nMOV result.color.w, 1;\nEND");
  EXPECT_NEAR(drawn()[0], 128, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  EXPECT_NEAR(drawn()[0], 128, 1) << "the comparison's result was sampled";
  EXPECT_EQ(integer(GL_SAMPLER_BINDING), 0) << "a sampler of the layer shows";
  EXPECT_NEAR(drawn()[0], 128, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  EXPECT_NEAR(drawn()[0], 128, 1);
}

TEST_F(Compare, AShadowTargetCompares) {
  makeProgram("!!ARBfp1.0\nOPTION ARB_fragment_program_shadow;\nTEMP t;\n"
              "TEX t, {0.5,0.5,0.25,1}, texture[0], SHADOW2D;\nMOV result.color, t;\n"
              "MOV result.color.w, 1;\nEND");
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  EXPECT_EQ(drawn()[0], 255) << "0.25 <= 0.5";
}

TEST_F(Draws, FeedbackCopies) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  makeProgram(kGreen);
  EXPECT_EQ(drawn(), kGreenPixel);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 32, 32, 0);
  load(kRed);
  EXPECT_EQ(drawn(), kRedPixel);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 16, 32);
  load("!!ARBfp1.0\nMUL result.color, fragment.position, {0.03125};\n"
       "TEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND");
  clear();
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-1, -1);
  glTexCoord2f(1, 0), glVertex2f(1, -1);
  glTexCoord2f(1, 1), glVertex2f(1, 1);
  glTexCoord2f(0, 1), glVertex2f(-1, 1);
  glEnd();
  EXPECT_EQ(readPixel(4, 16), kRedPixel);
  EXPECT_EQ(readPixel(28, 16), kGreenPixel);
}

TEST_F(Draws, AThousandProgramsComeAndGo) {
  for (int i = 0; i < 200; ++i) {
    const bool red = i % 2 != 0;
    const std::string text =
        "!!ARBfp1.0\n# " + std::to_string(i) + "\n" +
        std::string(red ? "MOV result.color, {1,0,0,1};" : "MOV result.color, {0,1,0,1};") +
        "\nEND";
    const GLuint name = makeProgram(text);
    ASSERT_EQ(drawn(), red ? kRedPixel : kGreenPixel) << i;
    glDeleteProgramsARB(1, &name);
  }
}

} // namespace
} // namespace api
