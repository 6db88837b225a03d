// The color matrix, attribute stacks and display lists of ARB_imaging, and the pixels that it does
// not affect.
#include "imaging.h"

namespace api::imaging {
namespace {

TEST_F(ImagingState, TheColorMatrixHasAStack) {
  EXPECT_EQ(integer(GL_COLOR_MATRIX_STACK_DEPTH), 1);
  const GLint most = integer(GL_MAX_COLOR_MATRIX_STACK_DEPTH);
  EXPECT_GE(most, 2);
  glMatrixMode(GL_COLOR);
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_COLOR);
  glTranslatef(1, 2, 3);
  glPushMatrix();
  glScalef(2, 2, 2);
  EXPECT_EQ(integer(GL_COLOR_MATRIX_STACK_DEPTH), 2);
  GLfloat matrix[16] = {};
  glGetFloatv(GL_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[0], 2);
  EXPECT_EQ(matrix[13], 2);
  glGetFloatv(GL_TRANSPOSE_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[7], 2);
  glMatrixMode(GL_MODELVIEW);
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_MODELVIEW);
  glLoadIdentity();
  EXPECT_EQ(integer(GL_COLOR_MATRIX_STACK_DEPTH), 2);
  glMatrixMode(GL_COLOR);
  glPopMatrix();
  glGetFloatv(GL_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[0], 1);
  EXPECT_EQ(matrix[14], 3);
  EXPECT_GL_ERROR(GL_STACK_UNDERFLOW, glPopMatrix());
  for (GLint i = 1; i < most; ++i)
    EXPECT_NO_GL_ERROR(glPushMatrix());
  EXPECT_GL_ERROR(GL_STACK_OVERFLOW, glPushMatrix());
  glPushAttrib(GL_TRANSFORM_BIT);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glPopAttrib();
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_COLOR);
  EXPECT_EQ(integer(GL_COLOR_MATRIX_STACK_DEPTH), most);
  glMatrixMode(GL_MODELVIEW);
  glPushAttrib(GL_TRANSFORM_BIT);
  glMatrixMode(GL_COLOR);
  glPopAttrib();
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_MODELVIEW);
  EXPECT_EQ(integer(GL_COLOR_MATRIX_STACK_DEPTH), most);
  glNewList(1, GL_COMPILE);
  glMatrixMode(GL_COLOR);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(5, 0, 0);
  glEndList();
  glCallList(1);
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_MODELVIEW);
  glGetFloatv(GL_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[14], 0);
  glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
  EXPECT_EQ(matrix[12], 5);
  glDeleteLists(1, 1);
}

TEST_F(ImagingState, TheProgramMatricesStayTheApplications) {
  const GLint count = integer(GL_MAX_PROGRAM_MATRICES_ARB);
  const GLenum last = GLenum(GL_MATRIX0_ARB + count - 1);
  glMatrixMode(last);
  glLoadIdentity();
  glTranslatef(7, 0, 0);
  glPushMatrix();
  glTranslatef(1, 0, 0);
  glMatrixMode(GL_COLOR);
  glScalef(3, 1, 1);
  glMatrixMode(last);
  GLfloat matrix[16] = {};
  glGetFloatv(GL_CURRENT_MATRIX_ARB, matrix);
  EXPECT_EQ(matrix[12], 8);
  glPopMatrix();
  glGetFloatv(GL_CURRENT_MATRIX_ARB, matrix);
  EXPECT_EQ(matrix[12], 7);
  glGetFloatv(GL_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[0], 3);
}

TEST_F(ImagingState, TheAttributeStackHasPixelModes) {
  const GLfloat color[] = {1, 0, 0, 1};
  glPushAttrib(GL_PIXEL_MODE_BIT);
  glEnable(GL_MINMAX);
  glPixelTransferf(GL_POST_CONVOLUTION_GREEN_BIAS, 0.5f);
  glPixelTransferi(GL_POST_COLOR_MATRIX_ALPHA_SCALE, 3);
  glConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, color);
  glColorTable(GL_COLOR_TABLE, GL_RGBA, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  EXPECT_EQ(number(GL_POST_CONVOLUTION_GREEN_BIAS), 0.5f);
  EXPECT_EQ(integer(GL_POST_COLOR_MATRIX_ALPHA_SCALE), 3);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(GL_MINMAX);
  glPixelTransferf(GL_POST_CONVOLUTION_GREEN_BIAS, 0.25f);
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_MINMAX), GL_TRUE);
  EXPECT_EQ(number(GL_POST_CONVOLUTION_GREEN_BIAS), 0.25f) << "of another group";
  glPopAttrib();
  EXPECT_EQ(glIsEnabled(GL_MINMAX), GL_FALSE);
  EXPECT_EQ(number(GL_POST_CONVOLUTION_GREEN_BIAS), 0);
  EXPECT_EQ(number(GL_POST_COLOR_MATRIX_ALPHA_SCALE), 1);
  GLfloat border[4] = {};
  glGetConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, border);
  EXPECT_EQ(border[0], 0);
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 1) << "in no group";
}

/// Returns the red of the framebuffer's first pixel.
GLubyte red() {
  GLubyte bytes[4] = {};
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  return bytes[0];
}

TEST_F(ImagingState, CommandsAreInLists) {
  const GLfloat inverted[] = {1, 0};
  glMinmax(GL_MINMAX, GL_RGBA, GL_FALSE); // imaging is used
  glNewList(1, GL_COMPILE);
  glColorTable(GL_COLOR_TABLE, GL_INTENSITY, 2, GL_RED, GL_FLOAT, inverted);
  glEnable(GL_COLOR_TABLE);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 0.4f);
  glEndList();
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 0);
  const GLubyte black[] = {0, 0, 0, 0};
  glNewList(2, GL_COMPILE);
  glWindowPos2i(0, 0);
  glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, black);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, black);
  glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 0, 0, 1, 0);
  glEndList();
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(2);
  EXPECT_EQ(red(), 0) << "nothing is enabled";
  glCallList(1);
  EXPECT_EQ(glIsEnabled(GL_COLOR_TABLE), GL_TRUE);
  glCallList(2);
  glDisable(GL_COLOR_TABLE);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 1);
  EXPECT_EQ(red(), 102);
  GLubyte texel[4] = {};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_EQ(texel[0], 102);
  EXPECT_EQ(texel[1], 255);
  glGetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_EQ(texel[0], 102) << "102 is nearer to 0, which becomes 1, and is scaled again";
  glDeleteLists(1, 2);
}

TEST_F(ImagingState, AListMayEndTheModeColor) {
  glNewList(1, GL_COMPILE);
  glMatrixMode(GL_COLOR);
  glLoadIdentity();
  glScalef(2, 2, 2);
  glEndList();
  glNewList(2, GL_COMPILE);
  glMatrixMode(GL_MODELVIEW);
  glEndList();
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_MODELVIEW);
  glCallList(1);
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_COLOR);
  glCallList(2);
  EXPECT_EQ(integer(GL_MATRIX_MODE), GL_MODELVIEW);
  GLfloat matrix[16] = {};
  glGetFloatv(GL_COLOR_MATRIX, matrix);
  EXPECT_EQ(matrix[0], 2);
  glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
  EXPECT_EQ(matrix[0], 1);
  glDeleteLists(1, 2);
}

TEST_F(ImagingState, DepthsAreNoColors) {
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 0);
  const GLfloat depth = 0.5f;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &depth);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 1);
  GLfloat read = 0;
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &read);
  EXPECT_NEAR(read, 0.5f, 1e-6f);
}

TEST_F(ImagingState, ColorIndicesBecomeColors) {
  const GLfloat map[] = {0, 1};
  for (const GLenum name : {GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B})
    glPixelMapfv(name, 2, map);
  glPixelTransferf(GL_RED_SCALE, 0); // affects components only, not indices
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 0.4f);
  const GLubyte indices[] = {1, 0};
  const GLubyte bits = 0x80;
  glWindowPos2i(0, 0);
  glDrawPixels(1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, indices);
  glWindowPos2i(0, 1);
  glDrawPixels(1, 1, GL_COLOR_INDEX, GL_BITMAP, &bits);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 1);
  glPixelTransferf(GL_RED_SCALE, 1);
  for (int y = 0; y < 2; ++y) {
    GLubyte bytes[4] = {};
    glReadPixels(0, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    EXPECT_EQ(bytes[0], 102) << y;
    EXPECT_EQ(bytes[1], 255) << y;
  }
}

TEST_F(ImagingState, VertexProgramsTrackTheColorMatrix) {
  NEEDS("GL_NV_vertex_program");
  glMatrixMode(GL_COLOR);
  glTranslatef(0, 5, 0);
  glMatrixMode(GL_MODELVIEW);
  EXPECT_NO_GL_ERROR(glTrackMatrixNV(GL_VERTEX_PROGRAM_NV, 4, GL_COLOR, GL_IDENTITY_NV));
  GLfloat row[4] = {};
  glGetProgramParameterfvNV(GL_VERTEX_PROGRAM_NV, 5, GL_PROGRAM_PARAMETER_NV, row);
  EXPECT_EQ(row[1], 1);
  EXPECT_EQ(row[3], 5);
  glTrackMatrixNV(GL_VERTEX_PROGRAM_NV, 4, GL_NONE, GL_IDENTITY_NV);
}

} // namespace
} // namespace api::imaging
