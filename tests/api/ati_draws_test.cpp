// ATI_fragment_shader: what is drawn. Defects of the bare host (Mesa 22.3.6) are tests that it
// skips: DOT2_ADD takes its third argument from the second, alpha reads what its colour wrote, and
// colour sum is left out.
#include "ati_shader.h"

#include <algorithm>
#include <cmath>

namespace api {
namespace {

using namespace ati;

constexpr GLuint kReg0 = GL_REG_0_ATI;
constexpr GLuint kReg1 = GL_REG_1_ATI;
constexpr Pixel kYellow = {255, 255, 0, 255};
constexpr Pixel kOpaqueBlack = {0, 0, 0, 255};

/// Colours are 8 bits and paths round on their own.
void expectNear(const Pixel &got, const Pixel &want, int tolerance = 2) {
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(got[i], want[i], tolerance) << "component " << i;
}

class AtiDraws : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glEnable(GL_FRAGMENT_SHADER_ATI);
    constant(GL_CON_0_ATI, 1, 0, 0, 1);
    constant(GL_CON_1_ATI, 0, 1, 0, 1);
    constant(GL_CON_2_ATI, 0.2f, 0.4f, 0.6f, 0.8f);
  }
};

/// A texture of one colour for `target`, bound and complete, on the active unit.
GLuint makeTexture(GLenum target, const Pixel &color) {
  const GLubyte texel[] = {GLubyte(color[0]), GLubyte(color[1]), GLubyte(color[2]),
                           GLubyte(color[3])};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(target, name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  switch (target) {
  case GL_TEXTURE_1D:
    glTexImage1D(target, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    break;
  case GL_TEXTURE_3D:
    glTexImage3D(target, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    break;
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, texel);
    break;
  default:
    glTexImage2D(target, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  }
  return name;
}

/// A shader that samples unit 0 at its coordinates and shows the sample.
void makeSamplingShader() {
  makeShader([] {
    sample(kReg0, GL_TEXTURE0);
    moveAll(kReg0);
  });
}

TEST_F(AtiDraws, ConstantsOfTheContextAndOfTheShader) {
  const GLuint global = makeConstantShader(GL_CON_0_ATI);
  EXPECT_EQ(drawn(), kRedPixel);
  const GLuint own = makeShader([] {
    constant(GL_CON_0_ATI, 0, 0, 1, 1);
    moveAll(GL_CON_0_ATI);
  });
  EXPECT_EQ(drawn(), kBluePixel);
  constant(GL_CON_0_ATI, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kBluePixel) << "the shader's own";
  glBindFragmentShaderATI(global);
  EXPECT_EQ(drawn(), kGreenPixel);
  glBindFragmentShaderATI(own);
  glBeginFragmentShaderATI(); // specified again: without the constant of its own
  moveAll(GL_CON_0_ATI);
  glEndFragmentShaderATI();
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(AtiDraws, EnableAndBinding) {
  const GLuint red = makeConstantShader(GL_CON_0_ATI);
  makeConstantShader(GL_CON_1_ATI);
  EXPECT_EQ(drawn(), kGreenPixel);
  glBindFragmentShaderATI(red);
  EXPECT_EQ(drawn(), kRedPixel);
  glDisable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_EQ(drawn(), kBluePixel) << "fixed function";
  glEnable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_EQ(drawn(), kRedPixel);
  glBindFragmentShaderATI(0);
  EXPECT_EQ(drawn(), kBluePixel) << "the default shader is empty: fixed function";
  glBeginFragmentShaderATI();
  moveAll(GL_CON_1_ATI);
  glEndFragmentShaderATI();
  EXPECT_EQ(drawn(), kGreenPixel) << "and can be specified";
  glBindFragmentShaderATI(red);
  glDeleteFragmentShaderATI(red);
  EXPECT_EQ(drawn(), kGreenPixel) << "deleting the bound one binds the default";
}

TEST_F(AtiDraws, AnInvalidShaderLeavesFixedFunction) {
  BARE_HOST_DIFFERS("draws with what was specified");
  makeConstantShader(GL_CON_0_ATI);
  glBeginFragmentShaderATI();
  color1(GL_MOV_ATI, kReg0, {GL_PRIMARY_COLOR});
  pass(kReg0, kReg0);
  color1(GL_MOV_ATI, kReg0, {kReg0});
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glEndFragmentShaderATI());
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(AtiDraws, Precedence) {
  makeConstantShader(GL_CON_0_ATI);
  makeProgram(kGreen);
  EXPECT_EQ(drawn(), kRedPixel);
  glEnable(kFragment);
  EXPECT_EQ(drawn(), kGreenPixel) << "an ARB program wins";
  glUseProgram(makeGlsl(nullptr, "void main() { gl_FragColor = vec4(1, 1, 0, 1); }"));
  EXPECT_EQ(drawn(), kYellow) << "and the application's GLSL over both";
  glDisable(kFragment);
  EXPECT_EQ(drawn(), kYellow);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(AtiDraws, InterpolatedColors) {
  makeShader([] {
    color2(GL_ADD_ATI, kReg0, {GL_PRIMARY_COLOR}, {GL_SECONDARY_INTERPOLATOR_ATI});
    alpha1(GL_MOV_ATI, kReg0, {GL_PRIMARY_COLOR});
  });
  glSecondaryColor3f(1, 0, 0);
  EXPECT_EQ(drawn(), (Pixel{255, 0, 255, 255}));
}

TEST_F(AtiDraws, AnArbVertexProgramFeedsIt) {
  makeShader([] {
    pass(kReg1, GL_TEXTURE3);
    color1(GL_MOV_ATI, kReg0, {kReg1});
    alpha1(GL_MOV_ATI, kReg0, {GL_PRIMARY_COLOR});
  });
  makeProgram("!!ARBvp1.0\nMOV result.position, vertex.position;\n"
              "MOV result.color, {0,0,0,1};\nMOV result.texcoord[3], {1,1,0,0};\nEND",
              kVertex);
  glEnable(kVertex);
  EXPECT_EQ(drawn(), kYellow);
}

TEST_F(AtiDraws, GlslVerticesAloneFeedIt) {
  makeConstantShader(GL_CON_0_ATI);
  glUseProgram(makeGlsl("void main() { gl_Position = gl_Vertex; }", nullptr));
  EXPECT_EQ(drawn(), kRedPixel);
  BARE_HOST_DIFFERS("a change of a constant is not seen");
  constant(GL_CON_0_ATI, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glUseProgram(0);
}

TEST_F(AtiDraws, GlslVerticesColorSumAndFog) {
  BARE_HOST_DIFFERS("leaves the colour sum out");
  makeConstantShader(GL_CON_0_ATI);
  glUseProgram(makeGlsl("void main() { gl_Position = gl_Vertex; gl_FogFragCoord = 0.5;"
                        " gl_FrontSecondaryColor = vec4(0, 1, 0, 0); }",
                        nullptr));
  EXPECT_EQ(drawn(), kRedPixel);
  glEnable(GL_COLOR_SUM);
  EXPECT_EQ(drawn(), kYellow);
  const GLfloat black[] = {0, 0, 0, 1};
  glFogfv(GL_FOG_COLOR, black);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glEnable(GL_FOG);
  expectNear(drawn(), {128, 128, 0, 255});
  glDisable(GL_COLOR_SUM);
  expectNear(drawn(), {128, 0, 0, 255});
}

TEST_F(AtiDraws, TwoPasses) {
  glActiveTexture(GL_TEXTURE1);
  makeTexture(GL_TEXTURE_2D, kYellow);
  glEnable(GL_TEXTURE_2D);
  glActiveTexture(GL_TEXTURE0);
  makeShader([] {
    color1(GL_MOV_ATI, GL_REG_2_ATI, {GL_CON_2_ATI});
    color1(GL_MOV_ATI, GL_REG_3_ATI, {GL_ONE});
    pass(GL_REG_2_ATI, GL_REG_2_ATI);
    sample(kReg1, GL_REG_2_ATI); // a dependent read
    color2(GL_MUL_ATI, kReg0, {kReg1}, {GL_REG_2_ATI});
    alpha1(GL_MOV_ATI, kReg0, {kReg1});
  });
  expectNear(drawn(), {51, 102, 0, 255});
}

TEST_F(AtiDraws, DestinationAndSourceModifiers) {
  makeShader([] {
    color1(GL_MOV_ATI, kReg0, {GL_CON_2_ATI, GL_NONE, GL_COMP_BIT_ATI}, GL_RED_BIT_ATI);
    color1(GL_MOV_ATI, kReg0, {GL_CON_2_ATI, GL_RED, GL_NONE}, GL_GREEN_BIT_ATI, GL_4X_BIT_ATI);
    color1(GL_MOV_ATI, kReg0, {GL_CON_2_ATI, GL_ALPHA, GL_BIAS_BIT_ATI | GL_2X_BIT_ATI},
           GL_BLUE_BIT_ATI);
    alpha2(GL_SUB_ATI, kReg0, {GL_CON_2_ATI, GL_BLUE}, {GL_CON_2_ATI, GL_RED, GL_NEGATE_BIT_ATI},
           GL_HALF_BIT_ATI);
  });
  expectNear(drawn(), {204, 204, 153, 102});
}

TEST_F(AtiDraws, ThirdArgumentOfDot2Add) {
  BARE_HOST_DIFFERS("blue is taken from the second argument");
  constant(GL_CON_0_ATI, 0.5f, 0.5f, 0, 0);
  constant(GL_CON_1_ATI, 0.25f, 0.25f, 0.5f, 0);
  makeShader([] {
    color1(GL_MOV_ATI, kReg1, {GL_CON_1_ATI});
    color3(GL_DOT2_ADD_ATI, kReg0, {GL_CON_0_ATI}, {GL_CON_0_ATI}, {kReg1});
    alpha3(GL_DOT2_ADD_ATI, kReg0, {GL_CON_0_ATI}, {GL_CON_0_ATI}, {kReg1});
  });
  expectNear(drawn(), {255, 255, 255, 255}); // 0.25 + 0.25 + 0.5
  constant(GL_CON_1_ATI, 1, 1, 0, 0);
  expectNear(drawn(), {128, 128, 128, 128});
}

TEST_F(AtiDraws, AlphaReadsWhatWasBeforeItsColor) {
  BARE_HOST_DIFFERS("alpha reads the colour's result");
  makeShader([] {
    color1(GL_MOV_ATI, kReg0, {GL_CON_0_ATI});
    color1(GL_MOV_ATI, kReg0, {GL_CON_1_ATI}); // with the next, a pair
    alpha1(GL_MOV_ATI, kReg0, {kReg0, GL_RED});
  });
  EXPECT_EQ(drawn(), kGreenPixel);
}

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
  for (const Row &row : rows) { // each is enabled beside those before it, over which it has
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
  expectNear(drawn(), {128, 128, 0, 255}); // the sum is before the fog
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
