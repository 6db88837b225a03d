// Draws with NV_texture_shader, 2 and 3: the state they depend on, and the stages they replace.
#include "texture_shaders.h"

namespace api::shaders {
namespace {

/// Unit 0 passes its coordinates through, as a color that no environment uses. Unit 1 reads a
/// texture of four colors by its alpha and red, and its environment replaces.
class NvTextureShaderDraws : public NvTextureShaders {
protected:
  void SetUp() override {
    NvTextureShaders::SetUp();
    if (IsSkipped())
      return;
    glEnable(GL_TEXTURE_SHADER_NV);
    operation(GL_PASS_THROUGH_NV);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
    unit(1);
    m_four = makeFour();
    operation(GL_DEPENDENT_AR_TEXTURE_2D_NV);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    read(0.25f, 0.25f);
  }
  /// Sets the coordinates of the dependent read.
  static void read(float alpha, float red) { glMultiTexCoord4f(GL_TEXTURE0, red, 0, 0, alpha); }

  GLuint m_four = 0;
};

TEST_F(NvTextureShaderDraws, ADependentRead) {
  expectNear(drawn(), kRedPixel);
  read(0.75f, 0.25f);
  expectNear(drawn(), kGreenPixel);
  read(0.25f, 0.75f);
  expectNear(drawn(), kBluePixel);
  read(0.75f, 0.75f);
  expectNear(drawn(), kYellow);
  operation(GL_DEPENDENT_GB_TEXTURE_2D_NV);
  glMultiTexCoord4f(GL_TEXTURE0, 0, 0.25f, 0.75f, 0);
  expectNear(drawn(), kBluePixel);
}

TEST_F(NvTextureShaderDraws, BeforeCombiners) {
  read(0.75f, 0.25f); // green
  glEnable(GL_REGISTER_COMBINERS_NV);
  for (const GLenum variable : {GL_VARIABLE_A_NV, GL_VARIABLE_B_NV, GL_VARIABLE_C_NV})
    glFinalCombinerInputNV(variable, GL_ZERO, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_D_NV, GL_TEXTURE1, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_G_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV, GL_ALPHA);
  expectNear(drawn(), kGreenPixel);
  glFinalCombinerInputNV(GL_VARIABLE_D_NV, GL_TEXTURE0, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  expectNear(drawn(), {64, 0, 0, 255}); // the coordinates
  glFinalCombinerInputNV(GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  const GLfloat blue[] = {0, 0, 1, 1};
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, blue);
  expectNear(drawn(), kBluePixel);
}

TEST_F(NvTextureShaderDraws, ParametersReachTheNextDraw) {
  unit(0);
  const GLfloat offset[] = {0.5f, 0};
  makeTexel(GL_DSDT_NV, GL_DSDT_NV, GL_FLOAT, offset);
  operation(GL_TEXTURE_2D);
  unit(1);
  operation(GL_OFFSET_TEXTURE_2D_NV);
  glMultiTexCoord4f(GL_TEXTURE1, 0.25f, 0.25f, 0, 1);
  expectNear(drawn(), kGreenPixel); // s + 0.5
  const GLfloat turned[] = {0, 1, 0, 0}, none[] = {0, 0, 0, 0};
  glTexEnvfv(kShader, GL_OFFSET_TEXTURE_MATRIX_NV, turned); // t + 0.5
  expectNear(drawn(), kBluePixel);
  glTexEnvfv(kShader, GL_OFFSET_TEXTURE_MATRIX_NV, none);
  expectNear(drawn(), kRedPixel);
}

TEST_F(NvTextureShaderDraws, TexturesThatChangeConsistency) {
  expectNear(drawnIn(0, 0, 1), kRedPixel);
  glBindTexture(GL_TEXTURE_2D, 0); // incomplete: the unit passes on the primary color
  expectNear(drawnIn(0, 0, 1), kBluePixel);
  glBindTexture(GL_TEXTURE_2D, m_four);
  expectNear(drawnIn(0, 0, 1), kRedPixel);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  expectNear(drawnIn(0, 0, 1), kBluePixel);
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  expectNear(drawnIn(0, 0, 1), kRedPixel);
}

TEST_F(NvTextureShaderDraws, CulledFragments) {
  unit(0);
  operation(GL_CULL_FRAGMENT_NV);
  unit(1);
  operation(GL_NONE);
  glMultiTexCoord4f(GL_TEXTURE0, 1, 1, 1, 1);
  expectNear(drawnIn(0, 1, 0), kGreenPixel);
  glMultiTexCoord4f(GL_TEXTURE0, 1, -1, 1, 1);
  expectNear(drawnIn(0, 1, 0), kBlack);
  unit(0);
  const GLint modes[] = {GL_GEQUAL, GL_LESS, GL_GEQUAL, GL_GEQUAL};
  glTexEnviv(kShader, GL_CULL_MODES_NV, modes);
  expectNear(drawnIn(0, 1, 0), kGreenPixel);
  glMultiTexCoord4f(GL_TEXTURE0, 1, 0, 1, 1); // zero is not less
  expectNear(drawnIn(0, 1, 0), kBlack);
}

TEST_F(NvTextureShaderDraws, Precedence) {
  expectNear(drawnIn(0, 0, 1), kRedPixel);
  makeProgram(kGreen);
  glEnable(kFragment);
  expectNear(drawnIn(0, 0, 1), kGreenPixel);
  glDisable(kFragment);
  expectNear(drawnIn(0, 0, 1), kRedPixel);
  const GLuint glsl = makeGlsl(nullptr, "void main() { gl_FragColor = vec4(1.0, 1.0, 0.0, 1.0); }");
  glUseProgram(glsl);
  expectNear(drawnIn(0, 0, 1), kYellow);
  glUseProgram(0);
  expectNear(drawnIn(0, 0, 1), kRedPixel);
  glDeleteProgram(glsl);
  glDisable(GL_TEXTURE_SHADER_NV);
  expectNear(drawnIn(0, 0, 1), kBluePixel);
}

TEST_F(NvTextureShaderDraws, BesideVertexPrograms) {
  makeProgram("!!ARBvp1.0\nMOV result.position, vertex.position;\n"
              "MOV result.texcoord[0], {0.75,0,0,0.75};\nEND",
              kVertex);
  glEnable(kVertex);
  expectNear(drawn(), kYellow);
}

TEST_F(NvTextureShaderDraws, EnvironmentsThatChange) {
  read(0.75f, 0.25f); // green
  expectNear(drawnIn(1, 1, 0), kGreenPixel);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  expectNear(drawnIn(1, 1, 0), kYellow);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  expectNear(drawnIn(1, 1, 0), kGreenPixel);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_SUBTRACT);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_TEXTURE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
  expectNear(drawnIn(1, 1, 0), kRedPixel); // yellow less green
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
  expectNear(drawnIn(1, 1, 0), kYellow);
}

TEST_F(NvTextureShaderDraws, ConventionalTexturingOfTheirFormats) { // the amended table 3.18
  glDisable(GL_TEXTURE_SHADER_NV);
  unit(0);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const GLfloat signedColor[] = {1, -1, 0, 1};
  makeTexel(GL_SIGNED_RGBA_NV, GL_RGBA, GL_FLOAT, signedColor);
  glEnable(GL_TEXTURE_2D);
  expectNear(drawnIn(0, 0, 1), kRedPixel); // clamped
  const GLfloat hilo[] = {1, 1};
  makeTexel(GL_HILO_NV, GL_HILO_NV, GL_FLOAT, hilo);
  expectNear(drawnIn(0, 0, 1), kBluePixel); // no color: the previous one is kept
}

TEST_F(NvTextureShaderDraws, DepthTextures) {
  unit(1);
  const GLfloat depth = 0.5f;
  makeTexel(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  operation(GL_TEXTURE_2D);
  glMultiTexCoord4f(GL_TEXTURE1, 0, 0, 0.25f, 1);
  expectNear(drawnIn(1, 1, 1), {128, 128, 128, 255});
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  expectNear(drawnIn(1, 1, 1), {255, 255, 255, 255});
  glMultiTexCoord4f(GL_TEXTURE1, 0, 0, 0.75f, 1);
  expectNear(drawnIn(1, 1, 1), kOpaqueBlack);
}

TEST_F(NvTextureShaderDraws, DepthsThatAreReplaced) {
  // Unit 1 computes the dot product z; unit 2 computes w and the depth z / w.
  unit(0);
  const GLubyte white[] = {255, 255, 255, 255};
  makeTexel(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, white);
  operation(GL_TEXTURE_2D);
  unit(1);
  operation(GL_DOT_PRODUCT_NV);
  unit(2);
  operation(GL_DOT_PRODUCT_DEPTH_REPLACE_NV);
  glMultiTexCoord4f(GL_TEXTURE1, 0.25f, 0, 0, 1);
  glMultiTexCoord4f(GL_TEXTURE2, 0.5f, 0, 0, 1);
  expectNear(drawnIn(0, 1, 0), kGreenPixel);
  glMultiTexCoord4f(GL_TEXTURE1, 1.25f, 0, 0, 1); // beyond the depth range
  expectNear(drawnIn(0, 1, 0), kBlack);
  glMultiTexCoord4f(GL_TEXTURE1, -0.25f, 0, 0, 1);
  expectNear(drawnIn(0, 1, 0), kBlack);
}

TEST_F(NvTextureShaderDraws, FromDisplayLists) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  read(0.25f, 0.25f);
  glRectf(-1, -1, 0, 1);
  operation(GL_NONE); // for unit 1, the active one
  glRectf(0, -1, 1, 1);
  glEndList();
  glColor4f(0, 0, 1, 1);
  expectHalves(list, kRedPixel, kBluePixel);
  glDeleteLists(list, 1);
}

TEST_F(NvTextureShaderDraws, TexturesThatListsBind) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glRectf(-1, -1, 0, 1);
  glBindTexture(GL_TEXTURE_2D, 0); // incomplete
  glRectf(0, -1, 1, 1);
  glBindTexture(GL_TEXTURE_2D, m_four);
  glEndList();
  glColor4f(0, 0, 1, 1);
  expectHalves(list, kRedPixel, kBluePixel);
  glDeleteLists(list, 1);
}

TEST_F(NvTextureShaderDraws, EachCommandThatBinds) { // 0 is incomplete, so inconsistent
  glColor4f(0, 0, 1, 1);
  const auto draws = [&](const char *what, const auto &bind) {
    bind(m_four);
    EXPECT_EQ(drawn(), kRedPixel) << what;
    bind(0u);
    EXPECT_EQ(drawn(), kBluePixel) << what;
    bind(m_four);
    EXPECT_EQ(drawn(), kRedPixel) << what;
  };
  forEachBinding(1, draws);
}

TEST_F(NvTextureShaderDraws, Fog) {
  const GLfloat green[] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, green);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogCoordf(1);
  expectNear(drawn(), kRedPixel);
  glEnable(GL_FOG);
  expectNear(drawn(), kGreenPixel);
  glFogCoordf(0.5f);
  expectNear(drawn(), {128, 128, 0, 255});
}

} // namespace
} // namespace api::shaders
