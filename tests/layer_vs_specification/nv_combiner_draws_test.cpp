// Draws with register combiners: the state they depend on, and the stages they replace.
#include <thread>

#include "ati_draws.h"
#include "nv_combiners.h"

namespace api::combiners {
namespace {

/// The final combiner outputs spare0; stage 0 writes AB to it.
class NvCombinerDraws : public NvCombiners {
protected:
  void SetUp() override {
    NvCombiners::SetUp();
    if (IsSkipped())
      return;
    glEnable(GL_REGISTER_COMBINERS_NV);
    show(GL_SPARE0_NV);
    final(GL_VARIABLE_G_NV, GL_ZERO, GL_ALPHA, GL_UNSIGNED_INVERT_NV);
  }
  static void show(GLenum name, GLenum usage = GL_RGB) {
    for (const GLenum variable : {GL_VARIABLE_A_NV, GL_VARIABLE_B_NV, GL_VARIABLE_C_NV})
      final(variable, GL_ZERO);
    final(GL_VARIABLE_D_NV, name, usage);
  }
};

constexpr GLubyte kWhiteTexel[] = {255, 255, 255, 255};

/// Makes and binds a texture of one depth, 1.
GLuint makeDepths() {
  const GLfloat depth = 1;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &depth);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return name;
}

GLint boundTexture() {
  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  return name;
}

TEST_F(NvCombinerDraws, ConstantsReachTheNextDraw) {
  rgb(GL_VARIABLE_A_NV, GL_CONSTANT_COLOR0_NV);
  constant(GL_CONSTANT_COLOR0_NV, 1, 0, 0);
  expectNear(drawn(), kRedPixel);
  constant(GL_CONSTANT_COLOR0_NV, 0, 1, 0);
  expectNear(drawn(), kGreenPixel);
  const GLfloat blue[] = {0, 0, 1, 1};
  glCombinerStageParameterfvNV(GL_COMBINER0_NV, GL_CONSTANT_COLOR0_NV, blue);
  expectNear(drawn(), kGreenPixel);
  glEnable(GL_PER_STAGE_CONSTANTS_NV);
  expectNear(drawn(), kBluePixel);
  show(GL_CONSTANT_COLOR0_NV); // the final combiner uses the global ones
  expectNear(drawn(), kGreenPixel);
}

TEST_F(NvCombinerDraws, Precedence) {
  rgb(GL_VARIABLE_A_NV, GL_CONSTANT_COLOR0_NV);
  constant(GL_CONSTANT_COLOR0_NV, 1, 0, 0);
  expectNear(drawn(), kRedPixel);
  makeProgram(kGreen);
  glEnable(kFragment);
  expectNear(drawn(), kGreenPixel);
  glDisable(kFragment);
  expectNear(drawn(), kRedPixel);
  const GLuint glsl = makeGlsl(nullptr, "void main() { gl_FragColor = vec4(1.0, 1.0, 0.0, 1.0); }");
  glUseProgram(glsl);
  expectNear(drawn(), kYellow);
  glUseProgram(0);
  expectNear(drawn(), kRedPixel);
  glDeleteProgram(glsl);
  glDisable(GL_REGISTER_COMBINERS_NV);
  expectNear(drawn(), kBluePixel);
}

TEST_F(NvCombinerDraws, BesideVertexPrograms) {
  rgb(GL_VARIABLE_A_NV, GL_PRIMARY_COLOR_NV);
  rgb(GL_VARIABLE_B_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV);
  makeProgram("!!ARBvp1.0\nMOV result.position, vertex.position;\n"
              "MOV result.color, {0,1,0,1};\nEND",
              kVertex);
  glEnable(kVertex);
  expectNear(drawn(), kGreenPixel);
  glDisable(kVertex);
  expectNear(drawn(), kBluePixel);
}

TEST_F(NvCombinerDraws, TheTargetsThatAreEnabled) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  makeTexture(GL_TEXTURE_2D, kRedPixel);
  makeTexture(GL_TEXTURE_3D, kGreenPixel);
  glEnable(GL_TEXTURE_2D);
  expectNear(drawn(), kRedPixel);
  glEnable(GL_TEXTURE_3D); // takes precedence
  expectNear(drawn(), kGreenPixel);
  glDisable(GL_TEXTURE_3D);
  expectNear(drawn(), kRedPixel);
}

TEST_F(NvCombinerDraws, DepthTextures) { // table RC.2
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhiteTexel);
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  rgb(GL_VARIABLE_C_NV, GL_TEXTURE0, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA);
  rgb(GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV); // red by alpha, and all by color
  constant(GL_CONSTANT_COLOR0_NV, 1, 0, 0);
  expectNear(drawn(), {255, 255, 255, 255});
  const GLfloat depth = 0.5f;
  const auto isDepth = [&](const char *what) {
    for (const GLenum mode : {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA}) {
      glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GLint(mode));
      SCOPED_TRACE(what);
      expectNear(drawn(), {128, 0, 0, 255});
    }
  };
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &depth);
  isDepth("the image became one of depths");
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  glTexCoord4f(0, 0, 0.25f, 1);
  expectNear(drawn(), {255, 255, 255, 255}); // passes
  glTexCoord4f(0, 0, 0.75f, 1);
  expectNear(drawn(), kOpaqueBlack); // fails
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  isDepth("no longer compared");
  makeTexture(GL_TEXTURE_2D, kGreenPixel);
  expectNear(drawn(), {255, 255, 0, 255}); // another texture is bound: green, and red by its alpha
}

TEST_F(NvCombinerDraws, DepthImagesOfOtherCommands) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  glEnable(GL_TEXTURE_2D);
  makeTexture(GL_TEXTURE_2D, kRedPixel);
  expectNear(drawn(), kRedPixel);
  const auto isDepth = [](const char *what) { // a depth texture has no color (table RC.2)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    EXPECT_EQ(drawn(), kOpaqueBlack) << what;
  };
  const GLfloat depth = 1;
  const auto fill = [&] {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  };
  GLuint names[2] = {};
  glGenTextures(2, names);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, 1, 1);
  fill();
  isDepth("TexStorage");
  glBindTexture(GL_TEXTURE_2D, names[1]);
  glTextureImage2DEXT(names[1], GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT16, 1, 1, 0, GL_DEPTH_COMPONENT,
                      GL_FLOAT, &depth);
  isDepth("TextureImageEXT");
  glDeleteTextures(2, names);
}

/// Depth textures have no color (table RC.2).
TEST_F(NvCombinerDraws, EachCommandThatBinds) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  glEnable(GL_TEXTURE_2D);
  const GLuint red = makeTexture(GL_TEXTURE_2D, kRedPixel);
  const GLuint depths = makeDepths();
  const auto draws = [&](const char *what, const auto &bind) {
    glBindTexture(GL_TEXTURE_2D, red);
    EXPECT_EQ(drawn(), kRedPixel) << what;
    bind(depths);
    EXPECT_EQ(drawn(), kOpaqueBlack) << what;
    bind(red);
    EXPECT_EQ(drawn(), kRedPixel) << what;
  };
  forEachBinding(0, draws);
  draws("PopAttrib", [](GLuint name) {
    const GLint before = boundTexture();
    glBindTexture(GL_TEXTURE_2D, name);
    glPushAttrib(GL_TEXTURE_BIT);
    glBindTexture(GL_TEXTURE_2D, GLuint(before));
    drawn();
    glPopAttrib();
  });
  glBindTexture(GL_TEXTURE_2D, depths);
  EXPECT_EQ(drawn(), kOpaqueBlack);
  glDeleteTextures(1, &depths);
  drawn(); // an incomplete texture: undefined, and without an error
}

/// The second draw samples depths, by their alpha: mode and binding come from the list.
TEST_F(NvCombinerDraws, TexturesThatListsBind) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  rgb(GL_VARIABLE_C_NV, GL_TEXTURE0, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA);
  rgb(GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV);
  constant(GL_CONSTANT_COLOR0_NV, 0, 0, 1);
  glEnable(GL_TEXTURE_2D);
  const GLuint depths = makeDepths();
  const GLuint red = makeTexture(GL_TEXTURE_2D, {255, 0, 0, 0});
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glRectf(-1, -1, 0, 1);
  glBindTexture(GL_TEXTURE_2D, depths);
  glRectf(0, -1, 1, 1);
  glBindTexture(GL_TEXTURE_2D, red);
  glEndList();
  for (int call = 0; call < 2; ++call)
    expectHalves(list, kRedPixel, kBluePixel);
  glDeleteLists(list, 1);
}

TEST_F(NvCombinerDraws, DepthsThatAnotherThreadsContextMade) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  glEnable(GL_TEXTURE_2D);
  for (const auto profile : {GlContext::Profile::Core, GlContext::Profile::Compatibility}) {
    const GLuint texture = makeTexture(GL_TEXTURE_2D, kRedPixel);
    EXPECT_EQ(drawn(), kRedPixel);
    glFinish();
    std::thread([&] {
      eglBindAPI(EGL_OPENGL_API);
      const GlContext other(&m_context, profile);
      glBindTexture(GL_TEXTURE_2D, texture);
      const GLfloat depth = 1;
      glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   &depth);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glFinish();
    }).join();
    glBindTexture(GL_TEXTURE_2D, texture); // makes the change visible (OpenGL 4.6, 5.3.3)
    EXPECT_EQ(drawn(), kOpaqueBlack);
  }
}

TEST_F(NvCombinerDraws, Spare0BeginsWithTheAlphaOfTexture0) {
  makeTexture(GL_TEXTURE_2D, {255, 0, 0, 128});
  glEnable(GL_TEXTURE_2D);
  rgb(GL_VARIABLE_A_NV, GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA);
  expectNear(drawn(), {128, 128, 128, 255});
}

TEST_F(NvCombinerDraws, FogIsAnInput) {
  const GLfloat green[] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, green);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogCoordf(0.75f);
  show(GL_FOG, GL_ALPHA);
  expectNear(drawn(), {255, 255, 255, 255}); // disabled: one
  glEnable(GL_FOG);
  expectNear(drawn(), {64, 64, 64, 255});
  glFogf(GL_FOG_END, 1.5f);
  expectNear(drawn(), {128, 128, 128, 255});
  glFogi(GL_FOG_MODE, GL_EXP);
  glFogf(GL_FOG_DENSITY, 1);
  expectNear(drawn(), {120, 120, 120, 255}); // e^-0.75
  show(GL_FOG);
  expectNear(drawn(), kGreenPixel);
}

TEST_F(NvCombinerDraws, ColorSumClamp) {
  glSecondaryColor3f(0.75f, 0, 0);
  rgb(GL_VARIABLE_A_NV, GL_CONSTANT_COLOR0_NV); // 0.75
  constant(GL_CONSTANT_COLOR0_NV, 0.75f, 0, 0);
  // The final combiner computes sum * 0.5: B is the sum and A one half.
  final(GL_VARIABLE_A_NV, GL_CONSTANT_COLOR1_NV, GL_ALPHA);
  constant(GL_CONSTANT_COLOR1_NV, 0, 0, 0, 0.5f);
  final(GL_VARIABLE_B_NV, GL_SPARE0_PLUS_SECONDARY_COLOR_NV);
  final(GL_VARIABLE_D_NV, GL_ZERO);
  expectNear(drawn(), {128, 0, 0, 255});
  glCombinerParameteriNV(GL_COLOR_SUM_CLAMP_NV, GL_FALSE);
  expectNear(drawn(), {191, 0, 0, 255});
}

TEST_F(NvCombinerDraws, FromDisplayLists) {
  rgb(GL_VARIABLE_A_NV, GL_CONSTANT_COLOR0_NV);
  constant(GL_CONSTANT_COLOR0_NV, 1, 0, 0);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  constant(GL_CONSTANT_COLOR0_NV, 0, 1, 0);
  glRectf(-1, -1, 0, 1);
  rgb(GL_VARIABLE_A_NV, GL_PRIMARY_COLOR_NV);
  glRectf(0, -1, 1, 1);
  glEndList();
  glColor4f(0, 0, 1, 1);
  expectHalves(list, kGreenPixel, kBluePixel);
  glDeleteLists(list, 1);
}

TEST_F(NvCombinerDraws, WhatAListEnablesChoosesTheProgram) {
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0);
  makeTexture(GL_TEXTURE_2D, kRedPixel);
  makeTexture(GL_TEXTURE_3D, kGreenPixel);
  glEnable(GL_TEXTURE_2D);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glRectf(-1, -1, 0, 1);
  glEnable(GL_TEXTURE_3D);
  glRectf(0, -1, 1, 1);
  glDisable(GL_TEXTURE_3D);
  glEndList();
  expectHalves(list, kRedPixel, kGreenPixel);
  glDeleteLists(list, 1);
}

/// The combiners are typical of the years of Doom 3 and Quake III: a bump map's dot product,
/// doubled.
TEST_F(NvCombinerDraws, ADotProductOfExpandedNormals) {
  makeTexture(GL_TEXTURE_2D, {128, 128, 255, 255}); // (0, 0, 1)
  glEnable(GL_TEXTURE_2D);
  rgb(GL_VARIABLE_A_NV, GL_TEXTURE0, GL_EXPAND_NORMAL_NV);
  rgb(GL_VARIABLE_B_NV, GL_CONSTANT_COLOR0_NV, GL_EXPAND_NORMAL_NV);
  constant(GL_CONSTANT_COLOR0_NV, 0.5f, 0.5f, 0.75f);
  glCombinerOutputNV(GL_COMBINER0_NV, GL_RGB, GL_SPARE0_NV, GL_DISCARD_NV, GL_DISCARD_NV, GL_NONE,
                     GL_NONE, GL_TRUE, GL_FALSE, GL_FALSE);
  expectNear(drawn(), {128, 128, 128, 255});
  glCombinerOutputNV(GL_COMBINER0_NV, GL_RGB, GL_SPARE0_NV, GL_DISCARD_NV, GL_DISCARD_NV,
                     GL_SCALE_BY_ONE_HALF_NV, GL_NONE, GL_TRUE, GL_FALSE, GL_FALSE);
  expectNear(drawn(), {64, 64, 64, 255});
}

} // namespace
} // namespace api::combiners
