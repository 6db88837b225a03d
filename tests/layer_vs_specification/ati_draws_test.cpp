// ATI_fragment_shader: draws of shaders alone. Tests of defects of the bare host (Mesa 22.3.6) are
// skipped there: DOT2_ADD takes its third argument from the second, alpha reads what its color
// wrote, and color sum is missing.
#include "ati_draws.h"

namespace api {
namespace {

using namespace ati;

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
  glBeginFragmentShaderATI(); // specified again, without a constant of its own
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
    color1(GL_MOV_ATI, kReg0, {GL_CON_1_ATI}); // a pair with the next
    alpha1(GL_MOV_ATI, kReg0, {kReg0, GL_RED});
  });
  EXPECT_EQ(drawn(), kGreenPixel);
}

} // namespace
} // namespace api
