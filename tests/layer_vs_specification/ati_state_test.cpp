// ATI_fragment_shader with GL state that its draws depend on: texture targets, fog, color sum,
// lists, share groups. The test of color sum is skipped on the bare host (Mesa 22.3.6), which lacks
// it.
#include <cmath>

#include "ati_draws.h"

namespace api {
namespace {

using namespace ati;

TEST_F(AtiDraws, TheEnabledTargetIsSampled) {
  makeSamplingShader();
  struct Row {
    GLenum target;
    Pixel color;
  };
  const Row rows[] = {{GL_TEXTURE_1D, {255, 0, 0, 255}},
                      {GL_TEXTURE_2D, {0, 255, 0, 255}},
                      {GL_TEXTURE_RECTANGLE, {0, 0, 255, 255}},
                      {GL_TEXTURE_3D, {255, 255, 0, 255}},
                      {GL_TEXTURE_CUBE_MAP, {0, 255, 255, 255}}};
  glTexCoord3f(0.5f, 0.5f, 0.5f);
  for (const Row &row : rows)
    makeTexture(row.target, row.color);
  EXPECT_EQ(drawn()[0], 0) << "none is enabled";
  for (const Row &row : rows) { // each takes precedence over those before it, which stay enabled
    glEnable(row.target);       // precedence
    EXPECT_EQ(drawn(), row.color) << row.target;
  }
  for (int i = 4; i > 0; --i) {
    glDisable(rows[i].target);
    EXPECT_EQ(drawn(), rows[i - 1].color) << rows[i - 1].target;
  }
}

TEST_F(AtiDraws, UnitsWithoutATexture) {
  makeSamplingShader();
  makeTexture(GL_TEXTURE_2D, kYellow);
  const Pixel none = drawn();
  EXPECT_EQ((Pixel{none[0], none[1], none[2], 255}), kOpaqueBlack) << "disabled";
  glEnable(GL_TEXTURE_2D);
  EXPECT_EQ(drawn(), kYellow);
  glBindTexture(GL_TEXTURE_2D, 0);
  const Pixel incomplete = drawn();
  EXPECT_EQ((Pixel{incomplete[0], incomplete[1], incomplete[2], 255}), kOpaqueBlack);
}

TEST_F(AtiDraws, EnablesComeBackWithTheirGroup) {
  makeSamplingShader();
  makeTexture(GL_TEXTURE_1D, kRedPixel);
  makeTexture(GL_TEXTURE_2D, kGreenPixel);
  glEnable(GL_TEXTURE_1D);
  EXPECT_EQ(drawn(), kRedPixel);
  glPushAttrib(GL_TEXTURE_BIT);
  glEnable(GL_TEXTURE_2D);
  EXPECT_EQ(drawn(), kGreenPixel);
  glPopAttrib();
  EXPECT_EQ(drawn(), kRedPixel);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glEnable(GL_TEXTURE_2D);
  glEndList();
  EXPECT_EQ(drawn(), kRedPixel) << "not executed yet";
  glCallList(list);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(AtiDraws, CompareModeIsNone) {
  makeSamplingShader();
  glTexCoord3f(0.5f, 0.5f, 0.5f);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLfloat depth = 0.25f;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &depth);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  expectNear(drawn(), {64, 64, 64, 255});
  BARE_HOST_DIFFERS("compares");
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  expectNear(drawn(), {64, 64, 64, 255});
}

TEST_F(AtiDraws, FogOfEveryMode) {
  BARE_MESA_DIFFERS(25, "the first draw after glEnable(GL_FOG) has none");
  makeConstantShader(GL_CON_0_ATI);
  const GLfloat green[] = {0, 1, 0, 0};
  glFogfv(GL_FOG_COLOR, green);
  glFogf(GL_FOG_DENSITY, 0.5f);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 4);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogCoordf(1);
  EXPECT_EQ(drawn(), kRedPixel) << "not enabled";
  glEnable(GL_FOG);
  const auto expectFactor = [](double f) {
    expectNear(drawn(), {int(std::lround(255 * f)), int(std::lround(255 * (1 - f))), 0, 255});
  };
  expectFactor(std::exp(-0.5)); // EXP is the initial mode
  glFogi(GL_FOG_MODE, GL_LINEAR);
  expectFactor(0.75);
  const GLfloat exp2 = GL_EXP2;
  glFogfv(GL_FOG_MODE, &exp2);
  expectFactor(std::exp(-0.25));
  glFogf(GL_FOG_DENSITY, 1);
  expectFactor(std::exp(-1));
  glPushAttrib(GL_FOG_BIT);
  glFogf(GL_FOG_MODE, GL_LINEAR);
  expectFactor(0.75);
  glPopAttrib();
  expectFactor(std::exp(-1));
  glDisable(GL_FOG);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(AtiDraws, ColorSum) {
  BARE_HOST_DIFFERS("leaves it out");
  makeConstantShader(GL_CON_0_ATI);
  glSecondaryColor3f(0, 1, 0);
  EXPECT_EQ(drawn(), kRedPixel);
  glEnable(GL_COLOR_SUM);
  EXPECT_EQ(drawn(), kYellow);
  const GLfloat black[] = {0, 0, 0, 1};
  glFogfv(GL_FOG_COLOR, black);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogCoordf(0.5f);
  glEnable(GL_FOG);
  expectNear(drawn(), {128, 128, 0, 255}); // the sum comes before the fog
  glDisable(GL_FOG);
  glDisable(GL_COLOR_SUM);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(AtiDraws, SeparateSpecularColor) {
  BARE_HOST_DIFFERS("leaves the colour sum out");
  makeConstantShader(GL_CON_0_ATI);
  const GLfloat green[] = {0, 1, 0, 1};
  const GLfloat forward[] = {0, 0, 1, 0};
  glNormal3f(0, 0, 1);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, forward);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, green);
  EXPECT_EQ(drawn(), kRedPixel) << "SINGLE_COLOR: the specular part is in the primary";
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  EXPECT_EQ(drawn(), kYellow);
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(AtiDraws, BindAndConstantsInLists) {
  const GLuint red = makeConstantShader(GL_CON_0_ATI);
  const GLuint other = makeConstantShader(GL_CON_1_ATI);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBindFragmentShaderATI(red);
  constant(GL_CON_0_ATI, 0, 0, 1, 1);
  drawQuad();
  glEndList();
  glBindFragmentShaderATI(other);
  EXPECT_EQ(drawn(), kGreenPixel) << "only compiled";
  clear();
  glCallList(list);
  EXPECT_EQ(readPixel(), kBluePixel);
  EXPECT_EQ(drawn(), kBluePixel) << "the list's binding stays";
}

TEST_F(AtiDraws, SpecifiedWhileAListIsCompiled) {
  const GLuint name = makeConstantShader(GL_CON_0_ATI);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBeginFragmentShaderATI(); // none of this is compiled
  moveAll(GL_CON_1_ATI);
  glEndFragmentShaderATI();
  const GLuint fresh = glGenFragmentShadersATI(1);
  glEndList();
  EXPECT_NE(fresh, name);
  EXPECT_NE(fresh, 0u);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(AtiDraws, AListChangesWhatItsDrawsDependOn) {
  makeSamplingShader();
  makeTexture(GL_TEXTURE_1D, kRedPixel);
  makeTexture(GL_TEXTURE_2D, kGreenPixel);
  const GLuint list = glGenLists(1);
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    clear();
    glNewList(list, mode);
    glEnable(GL_TEXTURE_1D);
    glScissor(0, 0, 16, 32);
    glEnable(GL_SCISSOR_TEST);
    drawQuad();
    glEnable(GL_TEXTURE_2D);
    glScissor(16, 0, 16, 32);
    drawQuad();
    glDisable(GL_TEXTURE_1D);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_SCISSOR_TEST);
    glEndList();
    if (mode == GL_COMPILE)
      glCallList(list);
    EXPECT_EQ(readPixel(4, 16), kRedPixel) << mode;
    EXPECT_EQ(readPixel(28, 16), kGreenPixel) << mode;
  }
}

TEST_F(AtiDraws, ShareGroups) {
  BARE_HOST_DIFFERS("a shader that a context which is gone has specified reads freed memory");
  const GLuint name = makeConstantShader(GL_CON_0_ATI);
  EXPECT_EQ(drawn(), kRedPixel);
  {
    const GlContext second(&m_context);
    EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
    glEnable(GL_FRAGMENT_SHADER_ATI);
    EXPECT_EQ(drawn(), kBluePixel) << "the binding is the context's own";
    glBindFragmentShaderATI(name);
    constant(GL_CON_0_ATI, 0, 1, 0, 1);
    EXPECT_EQ(drawn(), kGreenPixel) << "and so are constants";
    glBeginFragmentShaderATI();
    moveAll(GL_CON_1_ATI);
    glEndFragmentShaderATI();
    constant(GL_CON_1_ATI, 1, 1, 0, 1);
    EXPECT_EQ(drawn(), kYellow);
  }
  m_context.makeCurrent();
  glBindFragmentShaderATI(name);
  EXPECT_EQ(drawn(), kGreenPixel) << "specified by the other context";
  {
    const GlContext alone;
    glEnable(GL_FRAGMENT_SHADER_ATI);
    glBindFragmentShaderATI(name);
    EXPECT_EQ(drawn(), kBluePixel) << "not of the share group";
  }
  m_context.makeCurrent();
}

TEST_F(AtiDraws, HostStateStaysTheApplications) {
  makeSamplingShader();
  makeTexture(GL_TEXTURE_2D, kYellow);
  glEnable(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE2);
  EXPECT_EQ(drawn(), kYellow);
  EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE2);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0);
  for (GLuint program = 1; program < 32; ++program)
    EXPECT_FALSE(glIsProgram(program) || glIsShader(program)) << program;
}

} // namespace
} // namespace api
