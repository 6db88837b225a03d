// ATI_text_fragment_shader, which only the layer offers: the target in the program API, and draws.
#include "ati_shader.h"

namespace api {
namespace {

constexpr GLenum kText = GL_TEXT_FRAGMENT_SHADER_ATI;
constexpr char kConstants[] = "!!ATIfs1.0\n"
                              "StartConstants;\n"
                              "  CONSTANT c0 = program.env[1];\n"
                              "  CONSTANT c1 = program.local[7];\n"
                              "  CONSTANT c2 = {0.0, 0.0, 1.0, 1.0};\n"
                              "EndConstants;\n"
                              "StartOutputPass;\n"
                              "  ADD r1, c0, c1;\n"
                              "  ADD r0, r1, c2;\n"
                              "EndPass;\n";
constexpr char kTextRed[] = "!!ATIfs1.0\n"
                            "StartConstants; CONSTANT c0 = {1.0, 0.0, 0.0, 1.0}; EndConstants;\n"
                            "StartOutputPass; MOV r0, c0; EndPass;\n";
constexpr char kTextGreen[] = "!!ATIfs1.0\n"
                              "StartConstants; CONSTANT c0 = {0.0, 1.0, 0.0, 1.0}; EndConstants;\n"
                              "StartOutputPass; MOV r0, c0; EndPass;\n";
constexpr char kSample[] = "!!ATIfs1.0\n"
                           "StartOutputPass; SampleMap r2, t0.str; MOV r0, r2; EndPass;\n";

#define NEEDS_TEXT_FORM() BARE_HOST_DIFFERS("has no ATI_text_fragment_shader")

using AtiText = ApiTest;

TEST_F(AtiText, ItIsAdvertised) {
  NEEDS_TEXT_FORM();
  EXPECT_TRUE(epoxy_has_gl_extension("GL_ATI_text_fragment_shader"));
  EXPECT_TRUE(epoxy_has_gl_extension("GL_ATI_fragment_shader"));
}

TEST_F(AtiText, EnableIsStateOfItsOwn) {
  NEEDS_TEXT_FORM();
  EXPECT_FALSE(glIsEnabled(kText));
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(kText);
  EXPECT_TRUE(glIsEnabled(kText));
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
  EXPECT_FALSE(glIsEnabled(kFragment));
  EXPECT_EQ(integer(kText), 1);
  glPopAttrib();
  EXPECT_EQ(integer(kText), 0);
}

TEST_F(AtiText, LoadingAndItsErrors) {
  NEEDS_TEXT_FORM();
  const GLuint name = makeProgram(kTextRed, kText);
  EXPECT_TRUE(glIsProgramARB(name));
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), -1);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB, kText), GLint(name));
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB, kText), GLint(sizeof kTextRed - 1));
  EXPECT_EQ(programiv(GL_PROGRAM_FORMAT_ARB, kText), GL_PROGRAM_FORMAT_ASCII_ARB);
  const std::string bad = "!!ATIfs1.0\nStartOutputPass;\n  MOV r0, nothing;\nEndPass;\n";
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(bad, kText));
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), GLint(bad.find("nothing")));
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB, kText), GLint(sizeof kTextRed - 1)) << "kept";
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(kRed, kText)); // the other language's header
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramARB(kFragment, name)); // another target
}

TEST_F(AtiText, EightParametersOfEachKind) {
  NEEDS_TEXT_FORM();
  makeProgram(kTextRed, kText);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB, kText), 8);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB, kText), 8);
  EXPECT_NO_GL_ERROR(glProgramEnvParameter4fARB(kText, 7, 1, 2, 3, 4));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramEnvParameter4fARB(kText, 8, 1, 2, 3, 4));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glProgramLocalParameter4fARB(kText, 8, 1, 2, 3, 4));
  GLfloat value[4] = {};
  glGetProgramEnvParameterfvARB(kText, 7, value);
  EXPECT_EQ(value[2], 3.0f) << "beyond [0,1] it is given back as it was set";
  glGetProgramEnvParameterfvARB(kFragment, 7, value);
  EXPECT_EQ(value[2], 0.0f) << "the targets' parameters are their own";
}

TEST_F(AtiText, ConstantsOfAllKinds) {
  NEEDS_TEXT_FORM();
  makeProgram(kConstants, kText);
  glEnable(kText);
  EXPECT_EQ(drawn(), kBluePixel);
  glProgramEnvParameter4fARB(kText, 1, 1, 0, 0, 0);
  EXPECT_EQ(drawn(), (Pixel{255, 0, 255, 255}));
  glProgramLocalParameter4fARB(kText, 7, 0, 1, 0, 0);
  EXPECT_EQ(drawn(), (Pixel{255, 255, 255, 255}));
}

TEST_F(AtiText, Precedence) {
  NEEDS_TEXT_FORM();
  glEnable(kText);
  EXPECT_EQ(drawn(), kBluePixel) << "object 0 is empty: fixed function";
  const GLfloat green[] = {0, 1, 0, 1};
  glSetFragmentShaderConstantATI(GL_CON_0_ATI, green);
  ati::makeConstantShader(GL_CON_0_ATI);
  glEnable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_EQ(drawn(), kGreenPixel) << "the API form, where the text is not valid";
  makeProgram(kTextRed, kText);
  EXPECT_EQ(drawn(), kRedPixel) << "the text form goes before it";
  makeProgram(kGreen);
  glEnable(kFragment);
  EXPECT_EQ(drawn(), kGreenPixel) << "an ARB program before both";
  glDisable(kFragment);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(AtiText, FixedFunctionStateOfTheDraw) {
  NEEDS_TEXT_FORM();
  makeProgram(kSample, kText);
  glEnable(kText);
  glActiveTexture(GL_TEXTURE2);
  const GLubyte texel[] = {255, 0, 0, 255};
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_1D, texture);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  glEnable(GL_TEXTURE_1D);
  EXPECT_EQ(drawn(), kRedPixel);
  glSecondaryColor3f(0, 1, 0);
  glEnable(GL_COLOR_SUM);
  EXPECT_EQ(drawn(), (Pixel{255, 255, 0, 255}));
  const GLfloat blue[] = {0, 0, 1, 0};
  glFogfv(GL_FOG_COLOR, blue);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogCoordf(1);
  glEnable(GL_FOG);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(AtiText, InLists) {
  NEEDS_TEXT_FORM();
  const GLuint red = makeProgram(kTextRed, kText);
  makeProgram(kTextGreen, kText);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBindProgramARB(kText, red);
  glEnable(kText);
  drawQuad();
  load(kConstants, kText);
  glProgramEnvParameter4fARB(kText, 1, 1, 0, 0, 0);
  glEndList();
  EXPECT_FALSE(glIsEnabled(kText));
  clear();
  glCallList(list);
  EXPECT_EQ(readPixel(), kRedPixel);
  EXPECT_EQ(drawn(), (Pixel{255, 0, 255, 255}));
}

TEST_F(AtiText, SharedLikeOtherPrograms) {
  NEEDS_TEXT_FORM();
  const GLuint name = makeProgram(kTextRed, kText);
  glEnable(kText);
  EXPECT_EQ(drawn(), kRedPixel);
  {
    const GlContext second(&m_context);
    glBindProgramARB(kText, name);
    load(kTextGreen, kText);
    EXPECT_EQ(drawn(), kBluePixel) << "not enabled here";
  }
  m_context.makeCurrent();
  glBindProgramARB(kText, name); // binding makes another context's changes visible
  EXPECT_EQ(drawn(), kGreenPixel);
}

} // namespace
} // namespace api
