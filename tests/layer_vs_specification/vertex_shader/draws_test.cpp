// EXT_vertex_shader: draws of shaders, and related state: lists, sharing, fixed function, vertex
// programs, clip planes, the raster position.
#include "vertex_shaders.h"

namespace api::vertex_shaders {
namespace {

constexpr GLfloat kRedValue[] = {1, 0, 0, 1}, kGreenValue[] = {0, 1, 0, 1};

TEST_F(EraVertexShaders, ShadesWhileItIsEnabled) {
  colored(glBindParameterEXT(GL_FOG_COLOR));
  glFogfv(GL_FOG_COLOR, kRedValue);
  EXPECT_EQ(drawn(), kBluePixel) << "not enabled";
  glEnable(GL_VERTEX_SHADER_EXT);
  EXPECT_EQ(drawn(), kRedPixel);
  glFogfv(GL_FOG_COLOR, kGreenValue);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDisable(GL_VERTEX_SHADER_EXT);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(EraVertexShaders, UndefinedShadersLeaveVerticesToFixedFunction) {
  glEnable(GL_VERTEX_SHADER_EXT);
  EXPECT_EQ(drawn(), kBluePixel);
  glBindVertexShaderEXT(glGenVertexShadersEXT(1));
  EXPECT_EQ(drawn(), kBluePixel);
  const GLuint local = symbol(GL_VECTOR_EXT, GL_LOCAL_EXT);
  const GLint most = integer(GL_MAX_VERTEX_SHADER_INSTRUCTIONS_EXT);
  shader([&] {
    move(GL_OUTPUT_COLOR0_EXT, glBindParameterEXT(GL_FOG_COLOR));
    for (GLint i = 0; i < most; ++i)
      glShaderOp2EXT(GL_OP_ADD_EXT, local, local, vertex());
  });
  EXPECT_GT(integer(GL_VERTEX_SHADER_INSTRUCTIONS_EXT), most);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_OPTIMIZED_EXT), 0);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(EraVertexShaders, InvariantsReachTheNextDraw) {
  const GLuint fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT, 2);
  glEnable(GL_VERTEX_SHADER_EXT);
  const GLuint shaders[] = {colored(fixed), colored(fixed + 1)};
  glSetInvariantEXT(fixed, GL_FLOAT, kRedValue);
  glSetInvariantEXT(fixed + 1, GL_FLOAT, kGreenValue);
  EXPECT_EQ(drawn(), kGreenPixel);
  glBindVertexShaderEXT(shaders[0]);
  EXPECT_EQ(drawn(), kRedPixel);
  glSetInvariantEXT(fixed, GL_FLOAT, kGreenValue);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDeleteVertexShaderEXT(shaders[0]);
  EXPECT_EQ(drawn(), kBluePixel) << "the default shader is undefined";
}

TEST_F(EraVertexShaders, VariantsByVertexAndByArray) {
  const GLuint varying = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  colored(varying);
  glEnable(GL_VERTEX_SHADER_EXT);
  glVariantfvEXT(varying, kRedValue);
  EXPECT_EQ(drawn(), kRedPixel);
  clear();
  glBegin(GL_QUADS);
  glVariantfvEXT(varying, kRedValue);
  glVertex2f(-1, -1);
  glVertex2f(-1, 1);
  glVariantfvEXT(varying, kGreenValue);
  glVertex2f(1, 1);
  glVertex2f(1, -1);
  glEnd();
  EXPECT_GT(readPixel(1, 16)[0], 230);
  EXPECT_GT(readPixel(30, 16)[1], 230);
  static const GLfloat kCorners[] = {-1, -1, 3, -1, -1, 3};
  static const GLfloat kColors[] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  glVertexPointer(2, GL_FLOAT, 0, kCorners);
  glVariantPointerEXT(varying, GL_FLOAT, 0, kColors);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableVariantClientStateEXT(varying);
  clear();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glDisableVariantClientStateEXT(varying);
  glDisableClientState(GL_VERTEX_ARRAY);
}

TEST_F(EraVertexShaders, ValuesOfLightsThatProgramsHaveNoNameOf) {
  const GLuint cutoff = glBindLightParameterEXT(GL_LIGHT0, GL_SPOT_CUTOFF);
  const GLuint scale = symbol(GL_SCALAR_EXT, GL_LOCAL_CONSTANT_EXT);
  const GLfloat ninetieth = 1.0f / 90;
  shader([&] {
    glSetLocalConstantEXT(scale, GL_FLOAT, &ninetieth);
    glShaderOp2EXT(GL_OP_MUL_EXT, GL_OUTPUT_COLOR0_EXT, cutoff, scale);
  });
  glEnable(GL_VERTEX_SHADER_EXT);
  for (const int degrees : {90, 0, 45}) {
    glLighti(GL_LIGHT0, GL_SPOT_CUTOFF, degrees);
    EXPECT_NEAR(drawn()[0], degrees * 255 / 90.0, 1);
  }
}

TEST_F(EraVertexShaders, TheColorMatrixWhereThereIsOne) {
  if (!epoxy_has_gl_extension("GL_ARB_imaging")) {
    EXPECT_GL_ERROR(GL_INVALID_ENUM, glBindParameterEXT(GL_COLOR_MATRIX));
    return;
  }
  const GLuint matrix = glBindParameterEXT(GL_COLOR_MATRIX);
  shader([&] { glShaderOp2EXT(GL_OP_MULTIPLY_MATRIX_EXT, GL_OUTPUT_COLOR0_EXT, matrix, color()); });
  glEnable(GL_VERTEX_SHADER_EXT);
  EXPECT_EQ(drawn(), kBluePixel);
  const GLfloat blueToRed[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  glMatrixMode(GL_COLOR);
  glLoadMatrixf(blueToRed);
  glMatrixMode(GL_MODELVIEW);
  EXPECT_EQ(invariant(matrix)[2], 1);
  clear();
  drawQuad();
  glMatrixMode(GL_COLOR); // it applies to pixels that are read too
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  EXPECT_EQ(readPixel(), kRedPixel);
}

TEST_F(EraVertexShaders, ListsBindSetAndEnable) {
  const GLuint fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT),
               varying = symbol(GL_VECTOR_EXT, GL_VARIANT_EXT);
  const GLuint byInvariant = colored(fixed), byVariant = colored(varying);
  glBindVertexShaderEXT(0);
  glSetInvariantEXT(fixed, GL_FLOAT, kGreenValue);
  const GLuint lists = glGenLists(2);
  glNewList(lists, GL_COMPILE);
  glBindVertexShaderEXT(byInvariant);
  glEnable(GL_VERTEX_SHADER_EXT);
  glSetInvariantEXT(fixed, GL_FLOAT, kRedValue);
  drawQuad();
  glEndList();
  EXPECT_EQ(integer(GL_VERTEX_SHADER_BINDING_EXT), 0);
  EXPECT_EQ(invariant(fixed)[1], 1) << "not executed yet";
  clear();
  glCallList(lists);
  EXPECT_EQ(readPixel(), kRedPixel);
  EXPECT_EQ(integer(GL_VERTEX_SHADER_BINDING_EXT), GLint(byInvariant));
  EXPECT_EQ(invariant(fixed)[0], 1);
  glNewList(lists + 1, GL_COMPILE_AND_EXECUTE);
  glBindVertexShaderEXT(byVariant);
  glVariantfvEXT(varying, kGreenValue);
  clear();
  drawQuad();
  glEndList();
  EXPECT_EQ(readPixel(), kGreenPixel);
  glVariantfvEXT(varying, kRedValue);
  glCallList(lists + 1);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glDeleteLists(lists, 2);
}

TEST_F(EraVertexShaders, VertexProgramsComeFirst) {
  colored(glBindParameterEXT(GL_FOG_COLOR));
  glFogfv(GL_FOG_COLOR, kRedValue);
  glEnable(GL_VERTEX_SHADER_EXT);
  makeProgram(
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, {0,1,0,1};\nEND",
      kVertex);
  glEnable(kVertex);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDisable(kVertex);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(EraVertexShaders, CoordinatesReachFragmentPrograms) {
  const GLuint fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT);
  shader([&] {
    glSwizzleEXT(GL_OUTPUT_TEXTURE_COORD2_EXT, fixed, GL_Y_EXT, GL_X_EXT, GL_ZERO_EXT, GL_ONE_EXT);
  });
  glSetInvariantEXT(fixed, GL_FLOAT, kRedValue);
  glEnable(GL_VERTEX_SHADER_EXT);
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[2];\nEND");
  glEnable(kFragment);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(EraVertexShaders, FogByItsOwnCoordinate) {
  const GLuint distance = symbol(GL_SCALAR_EXT, GL_INVARIANT_EXT);
  shader([&] {
    move(GL_OUTPUT_COLOR0_EXT, color());
    move(GL_OUTPUT_FOG_EXT, distance);
  });
  glEnable(GL_VERTEX_SHADER_EXT);
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glFogfv(GL_FOG_COLOR, kRedValue);
  const GLfloat near = 0, far = 2;
  glSetInvariantEXT(distance, GL_FLOAT, &near);
  EXPECT_EQ(drawn(), kBluePixel);
  glSetInvariantEXT(distance, GL_FLOAT, &far);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(EraVertexShaders, ClipPlanesActInClipCoordinates) {
  colored(color());
  glEnable(GL_VERTEX_SHADER_EXT);
  const GLdouble right[] = {1, 0, 0, 0};
  glClipPlane(GL_CLIP_PLANE0, right);
  glEnable(GL_CLIP_PLANE0);
  clear();
  drawQuad();
  EXPECT_EQ(readPixel(4, 16), kBlack);
  EXPECT_EQ(readPixel(28, 16), kBluePixel);
}

TEST_F(EraVertexShaders, TheRasterPositionIsFixedFunctions) {
  shader([] { glShaderOp1EXT(GL_OP_NEGATE_EXT, GL_OUTPUT_VERTEX_EXT, vertex()); });
  glEnable(GL_VERTEX_SHADER_EXT);
  (void)drawn();
  glRasterPos2f(0.5f, 0.5f);
  GLfloat position[4] = {};
  glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
  EXPECT_FLOAT_EQ(position[0], 24);
  EXPECT_EQ(glIsEnabled(GL_VERTEX_SHADER_EXT), GL_TRUE);
}

TEST_F(EraVertexShaders, SharedByContexts) {
  const GLuint fixed = symbol(GL_VECTOR_EXT, GL_INVARIANT_EXT);
  const GLuint name = colored(fixed);
  glSetInvariantEXT(fixed, GL_FLOAT, kRedValue);
  {
    const GlContext other(&m_context);
    glBindVertexShaderEXT(name);
    glEnable(GL_VERTEX_SHADER_EXT);
    EXPECT_EQ(drawn(), kRedPixel);
    m_context.makeCurrent();
    glSetInvariantEXT(fixed, GL_FLOAT, kGreenValue);
    other.makeCurrent();
    EXPECT_EQ(drawn(), kGreenPixel);
    m_context.makeCurrent();
    glBeginVertexShaderEXT(); // the same shader, with another meaning
    move(GL_OUTPUT_VERTEX_EXT, vertex());
    glSwizzleEXT(GL_OUTPUT_COLOR0_EXT, fixed, GL_Y_EXT, GL_X_EXT, GL_Z_EXT, GL_W_EXT);
    glEndVertexShaderEXT();
    other.makeCurrent();
    EXPECT_EQ(drawn(), kRedPixel);
  }
  m_context.makeCurrent();
}

} // namespace
} // namespace api::vertex_shaders
