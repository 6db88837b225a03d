// ARB_imaging's state: queries, errors, proxies, attribute stacks, display lists, the colour
// matrix.
#include <cmath>

#include "imaging.h"

namespace api::imaging {
namespace {

class ImagingState : public ImagingTest {};

constexpr GLenum kTables[] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE,
                              GL_POST_COLOR_MATRIX_COLOR_TABLE};
constexpr GLenum kFilters[] = {GL_CONVOLUTION_1D, GL_CONVOLUTION_2D, GL_SEPARABLE_2D};

GLint table(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetColorTableParameteriv(target, pname, &value);
  return value;
}
GLint filter(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetConvolutionParameteriv(target, pname, &value);
  return value;
}
GLint histogram(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetHistogramParameteriv(target, pname, &value);
  return value;
}
GLfloat number(GLenum pname) {
  GLfloat value = -1;
  glGetFloatv(pname, &value);
  return value;
}

const GLubyte kBytes[] = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160};

TEST_F(ImagingState, EnablesAreOffAtFirst) {
  for (const GLenum cap :
       {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE, GL_POST_COLOR_MATRIX_COLOR_TABLE,
        GL_CONVOLUTION_1D, GL_CONVOLUTION_2D, GL_SEPARABLE_2D, GL_HISTOGRAM, GL_MINMAX}) {
    EXPECT_EQ(glIsEnabled(cap), GL_FALSE);
    glEnable(cap);
    EXPECT_EQ(glIsEnabled(cap), GL_TRUE);
    EXPECT_EQ(integer(cap), 1);
    glDisable(cap);
    EXPECT_EQ(glIsEnabled(cap), GL_FALSE);
  }
}

TEST_F(ImagingState, ATableIsGivenAndReturned) {
  for (const GLenum target : kTables) {
    EXPECT_EQ(table(target, GL_COLOR_TABLE_WIDTH), 0);
    EXPECT_EQ(table(target, GL_COLOR_TABLE_FORMAT), GL_RGBA);
    glColorTable(target, GL_RGBA8, 4, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
    EXPECT_EQ(table(target, GL_COLOR_TABLE_WIDTH), 4);
    EXPECT_EQ(table(target, GL_COLOR_TABLE_FORMAT), GL_RGBA8);
    EXPECT_EQ(table(target, GL_COLOR_TABLE_GREEN_SIZE), 8);
    EXPECT_EQ(table(target, GL_COLOR_TABLE_LUMINANCE_SIZE), 0);
    GLubyte read[16] = {};
    glGetColorTable(target, GL_RGBA, GL_UNSIGNED_BYTE, read);
    EXPECT_TRUE(std::equal(std::begin(read), std::end(read), kBytes));
    glColorSubTable(target, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
    glGetColorTable(target, GL_BLUE, GL_UNSIGNED_BYTE, read);
    EXPECT_EQ(read[0], 30);
    EXPECT_EQ(read[1], 30);
    EXPECT_EQ(read[2], 70);
    EXPECT_EQ(read[3], 150);
  }
  glColorTable(GL_COLOR_TABLE, GL_LUMINANCE_ALPHA, 2, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  GLubyte read[8] = {};
  glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read);
  const GLubyte expected[] = {10, 0, 0, 40, 50, 0, 0, 80};
  EXPECT_TRUE(std::equal(std::begin(read), std::end(read), expected)) << "luminance is red";
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_LUMINANCE_SIZE), 8);
}

TEST_F(ImagingState, ATableIsScaledAndClamped) {
  const GLfloat scale[] = {2, 1, 0, 1}, bias[] = {0, -0.5f, 1, 0};
  glColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, scale);
  glColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, bias);
  GLfloat value[4] = {};
  glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, value);
  EXPECT_TRUE(std::equal(std::begin(value), std::end(value), bias));
  const GLfloat colors[] = {0.75f, 0.25f, 0.5f, 0.5f, 0.25f, 1, 1, 1};
  glColorTable(GL_COLOR_TABLE, GL_RGBA16, 2, GL_RGBA, GL_FLOAT, colors);
  GLfloat read[8] = {};
  glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_FLOAT, read);
  const GLfloat expected[] = {1, 0, 1, 0.5f, 0.5f, 0.5f, 1, 1};
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(read[i], expected[i], 1.0f / 65535) << i;
}

TEST_F(ImagingState, TablesAreCopiedFromTheFramebuffer) {
  glWindowPos2i(0, 0);
  glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  glCopyColorTable(GL_COLOR_TABLE, GL_RGBA8, 0, 0, 4);
  glCopyColorSubTable(GL_COLOR_TABLE, 2, 0, 0, 1);
  GLubyte read[16] = {};
  glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[4], 50);
  EXPECT_EQ(read[8], 10);
  EXPECT_EQ(read[15], 160);
  glCopyConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 0, 0, 3);
  EXPECT_EQ(filter(GL_CONVOLUTION_1D, GL_CONVOLUTION_WIDTH), 3);
  glGetConvolutionFilter(GL_CONVOLUTION_1D, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[8], 90);
  glCopyConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 1, 0, 2, 1);
  EXPECT_EQ(filter(GL_CONVOLUTION_2D, GL_CONVOLUTION_WIDTH), 2);
  EXPECT_EQ(filter(GL_CONVOLUTION_2D, GL_CONVOLUTION_HEIGHT), 1);
  glGetConvolutionFilter(GL_CONVOLUTION_2D, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 50);
}

TEST_F(ImagingState, Proxies) {
  glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 16, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 16);
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_RED_SIZE), 8);
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 0) << "no table is made";
  EXPECT_NO_GL_ERROR(
      glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 1 << 24, GL_RGB, GL_UNSIGNED_BYTE, nullptr));
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 0);
  glHistogram(GL_PROXY_HISTOGRAM, 256, GL_RGBA, GL_TRUE);
  EXPECT_EQ(histogram(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH), 256);
  EXPECT_EQ(histogram(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_SINK), GL_TRUE);
  EXPECT_EQ(histogram(GL_HISTOGRAM, GL_HISTOGRAM_WIDTH), 0);
  glNewList(1, GL_COMPILE);
  glHistogram(GL_PROXY_HISTOGRAM, 64, GL_RGBA, GL_FALSE);
  glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 32, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(histogram(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH), 64) << "executed at once";
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 32);
  glEndList();
  glDeleteLists(1, 1);
}

TEST_F(ImagingState, FiltersAreGivenAndReturned) {
  const GLfloat weights[] = {-2, 0.5f, 3, 1, 0.25f, 8, 0, -1, 4, 5, 6, 7};
  const GLfloat scale[] = {2, 1, 1, 1}, bias[] = {0, 1, 0, 0};
  glConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_FILTER_SCALE, scale);
  glConvolutionParameterfv(GL_CONVOLUTION_1D, GL_CONVOLUTION_FILTER_BIAS, bias);
  glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 3, GL_RGBA, GL_FLOAT, weights);
  GLfloat read[12] = {};
  glGetConvolutionFilter(GL_CONVOLUTION_1D, GL_RGBA, GL_FLOAT, read);
  EXPECT_FLOAT_EQ(read[0], -4) << "nothing is clamped";
  EXPECT_FLOAT_EQ(read[5], 9);
  glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 1, 3, GL_RGBA, GL_FLOAT, weights);
  EXPECT_EQ(filter(GL_CONVOLUTION_2D, GL_CONVOLUTION_HEIGHT), 3);
  EXPECT_EQ(filter(GL_CONVOLUTION_2D, GL_CONVOLUTION_FORMAT), GL_RGBA);
  glSeparableFilter2D(GL_SEPARABLE_2D, GL_LUMINANCE, 2, 3, GL_RGBA, GL_FLOAT, weights, weights);
  EXPECT_EQ(filter(GL_SEPARABLE_2D, GL_CONVOLUTION_WIDTH), 2);
  EXPECT_EQ(filter(GL_SEPARABLE_2D, GL_CONVOLUTION_HEIGHT), 3);
  GLfloat row[2] = {}, column[3] = {};
  glGetSeparableFilter(GL_SEPARABLE_2D, GL_LUMINANCE, GL_FLOAT, row, column, nullptr);
  EXPECT_FLOAT_EQ(row[1], 0.25f);
  EXPECT_FLOAT_EQ(column[2], 4);
  for (const GLenum target : kFilters) {
    EXPECT_EQ(filter(target, GL_CONVOLUTION_BORDER_MODE), GL_REDUCE);
    EXPECT_GE(filter(target, GL_MAX_CONVOLUTION_WIDTH), 3);
    glConvolutionParameterf(target, GL_CONVOLUTION_BORDER_MODE, GL_REPLICATE_BORDER);
    EXPECT_EQ(filter(target, GL_CONVOLUTION_BORDER_MODE), GL_REPLICATE_BORDER);
  }
  const GLint most[] = {0x7FFFFFFF, 0, 0, 0};
  glConvolutionParameteriv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, most);
  GLfloat color[4] = {};
  glGetConvolutionParameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, color);
  EXPECT_FLOAT_EQ(color[0], 1);
  GLint integers[4] = {};
  glGetConvolutionParameteriv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, integers);
  EXPECT_EQ(integers[0], 0x7FFFFFFF);
}

TEST_F(ImagingState, HistogramsAreOfAnyType) {
  glHistogram(GL_HISTOGRAM, 2, GL_RGB, GL_FALSE);
  EXPECT_EQ(histogram(GL_HISTOGRAM, GL_HISTOGRAM_FORMAT), GL_RGB);
  EXPECT_GT(histogram(GL_HISTOGRAM, GL_HISTOGRAM_RED_SIZE), 0);
  EXPECT_EQ(histogram(GL_HISTOGRAM, GL_HISTOGRAM_ALPHA_SIZE), 0);
  glEnable(GL_HISTOGRAM);
  const std::vector<GLubyte> bytes(300 * 4, 255);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 300, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  glDisable(GL_HISTOGRAM);
  GLubyte small[6] = {};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_BGR, GL_UNSIGNED_BYTE, small);
  EXPECT_EQ(small[0], 0);
  EXPECT_EQ(small[3], 255) << "as much as the type has";
  GLfloat floats[2] = {};
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_GREEN, GL_FLOAT, floats);
  EXPECT_EQ(floats[1], 300);
  GLuint packed[2] = {};
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, packed);
  EXPECT_EQ(packed[1], 300u << 22 | 300u << 12 | 300u << 2) << "no alpha is counted";
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, 12, nullptr, GL_STATIC_READ);
  glGetHistogram(GL_HISTOGRAM, GL_TRUE, GL_RED, GL_UNSIGNED_INT, reinterpret_cast<void *>(4));
  EXPECT_GL_ERROR(
      GL_INVALID_OPERATION,
      glGetHistogram(GL_HISTOGRAM, GL_TRUE, GL_RED, GL_UNSIGNED_INT, reinterpret_cast<void *>(8)));
  GLuint count = 0;
  glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 8, 4, &count);
  EXPECT_EQ(count, 300u);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
  GLfloat left[6] = {};
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGB, GL_FLOAT, left);
  EXPECT_EQ(left[3], 0) << "red alone was asked for and reset";
  EXPECT_EQ(left[4], 300);
  glResetHistogram(GL_HISTOGRAM);
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGB, GL_FLOAT, left);
  EXPECT_EQ(left[4], 0);
}

TEST_F(ImagingState, SinksTakeThePixels) {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  glHistogram(GL_HISTOGRAM, 1, GL_RGBA, GL_TRUE);
  glEnable(GL_HISTOGRAM);
  glMinmax(GL_MINMAX, GL_LUMINANCE, GL_FALSE);
  glEnable(GL_MINMAX);
  glWindowPos2i(0, 0);
  glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes + 4);
  GLuint counts[4] = {};
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_INT, counts);
  EXPECT_EQ(counts[2], 5u);
  GLfloat minmax[4] = {};
  glGetMinmax(GL_MINMAX, GL_FALSE, GL_LUMINANCE, GL_FLOAT, minmax);
  EXPECT_GT(minmax[0], minmax[1]) << "none came so far";
  GLubyte read[4] = {99, 99, 99, 99};
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 99);
  glDisable(GL_HISTOGRAM);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 0) << "nothing was drawn";
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 10);
  glMinmax(GL_MINMAX, GL_RGBA, GL_TRUE);
  glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  GLubyte bytes[8] = {};
  glGetMinmax(GL_MINMAX, GL_TRUE, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  EXPECT_EQ(bytes[0], 10);
  EXPECT_EQ(bytes[7], 160);
  glDisable(GL_MINMAX);
  GLint value = -1;
  glGetMinmaxParameteriv(GL_MINMAX, GL_MINMAX_SINK, &value);
  EXPECT_EQ(value, GL_TRUE);
}

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

/// The first pixel of the framebuffer.
GLubyte red() {
  GLubyte bytes[4] = {};
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  return bytes[0];
}

TEST_F(ImagingState, CommandsAreInLists) {
  const GLfloat inverted[] = {1, 0};
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 1); // imaging is used
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

TEST_F(ImagingState, MemoryOfAKnownSize) {
  if (!epoxy_has_gl_extension("GL_ARB_robustness"))
    GTEST_SKIP() << "GL_ARB_robustness is not offered here";
  glColorTable(GL_COLOR_TABLE, GL_RGBA8, 4, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  GLubyte read[16] = {};
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glGetnColorTableARB(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, 15, read));
  EXPECT_EQ(read[0], 0);
  EXPECT_NO_GL_ERROR(glGetnColorTableARB(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, 16, read));
  EXPECT_EQ(read[15], 160);
  glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 2, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glGetnConvolutionFilterARB(GL_CONVOLUTION_1D, GL_RGBA,
                                                                   GL_UNSIGNED_BYTE, 7, read));
  EXPECT_NO_GL_ERROR(
      glGetnConvolutionFilterARB(GL_CONVOLUTION_1D, GL_RGBA, GL_UNSIGNED_BYTE, 8, read));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glGetnMinmaxARB(GL_MINMAX, GL_FALSE, GL_RED, GL_FLOAT, 7, read));
  EXPECT_NO_GL_ERROR(glGetnMinmaxARB(GL_MINMAX, GL_FALSE, GL_RED, GL_FLOAT, 8, read));
  glHistogram(GL_HISTOGRAM, 2, GL_RGBA, GL_FALSE);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glGetnHistogramARB(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_SHORT, 15, read));
  EXPECT_NO_GL_ERROR(
      glGetnHistogramARB(GL_HISTOGRAM, GL_FALSE, GL_RGBA, GL_UNSIGNED_SHORT, 16, read));
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 0.4f);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glReadnPixelsARB(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 3, read));
  EXPECT_NO_GL_ERROR(glReadnPixelsARB(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4, read));
  EXPECT_EQ(read[0], 102);
  glPixelTransferf(GL_POST_COLOR_MATRIX_RED_SCALE, 1);
}

TEST_F(ImagingState, ColorIndicesBecomeColors) {
  const GLfloat map[] = {0, 1};
  for (const GLenum name : {GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B})
    glPixelMapfv(name, 2, map);
  glPixelTransferf(GL_RED_SCALE, 0); // of components, which indices are not
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
  if (!epoxy_has_gl_extension("GL_NV_vertex_program"))
    GTEST_SKIP() << "GL_NV_vertex_program is not offered here";
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

TEST_F(ImagingState, Errors) {
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTable(GL_TEXTURE_2D, GL_RGBA, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTable(GL_COLOR_TABLE, GL_RED, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glColorTable(GL_COLOR_TABLE, GL_RGBA, 1, GL_DEPTH_COMPONENT,
                                                GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTable(GL_COLOR_TABLE, GL_RGBA, 1, GL_RGBA, GL_LINEAR, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glColorTable(GL_COLOR_TABLE, GL_RGBA, 1, GL_RGBA,
                                                     GL_UNSIGNED_SHORT_5_6_5, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glColorTable(GL_COLOR_TABLE, GL_RGBA, 3, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glColorTable(GL_COLOR_TABLE, GL_RGBA, -1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_TABLE_TOO_LARGE, glColorTable(GL_COLOR_TABLE, GL_RGBA, 1 << 24, GL_RGBA,
                                                   GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glColorSubTable(GL_COLOR_TABLE, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorSubTable(GL_PROXY_COLOR_TABLE, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  const GLfloat four[4] = {};
  GLfloat value[4] = {};
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTableParameterfv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_SCALE, four));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, four));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetColorTableParameterfv(GL_COLOR_TABLE, GL_CONVOLUTION_WIDTH, value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, value));

  EXPECT_GL_ERROR(GL_INVALID_ENUM, glConvolutionFilter1D(GL_CONVOLUTION_2D, GL_RGBA, 1, GL_RGBA,
                                                         GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 1 << 20, 1,
                                                          GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glSeparableFilter2D(GL_SEPARABLE_2D, GL_RGBA, 1, -1, GL_RGBA,
                                                        GL_UNSIGNED_BYTE, kBytes, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_DEPTH_COMPONENT, 1,
                                                         1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glConvolutionParameteri(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, 0));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glConvolutionParameteri(GL_CONVOLUTION_1D,
                                                           GL_CONVOLUTION_BORDER_MODE, GL_REPEAT));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glConvolutionParameterfv(GL_HISTOGRAM, GL_CONVOLUTION_FILTER_BIAS, four));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetConvolutionFilter(GL_SEPARABLE_2D, GL_RGBA, GL_FLOAT, value));

  EXPECT_GL_ERROR(GL_INVALID_ENUM, glHistogram(GL_MINMAX, 1, GL_RGBA, GL_FALSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glHistogram(GL_HISTOGRAM, 1, GL_INTENSITY, GL_FALSE));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glHistogram(GL_HISTOGRAM, 100, GL_RGBA, GL_FALSE));
  EXPECT_GL_ERROR(GL_TABLE_TOO_LARGE, glHistogram(GL_HISTOGRAM, 1 << 24, GL_RGBA, GL_FALSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glMinmax(GL_MINMAX, GL_INTENSITY8, GL_FALSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glResetHistogram(GL_MINMAX));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glResetMinmax(GL_HISTOGRAM));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetHistogram(GL_PROXY_HISTOGRAM, GL_FALSE, GL_RGBA, GL_FLOAT, value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetMinmax(GL_MINMAX, GL_FALSE, GL_COLOR_INDEX, GL_FLOAT, value));
  GLint integers[4] = {};
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetMinmaxParameteriv(GL_MINMAX, GL_HISTOGRAM_WIDTH, integers));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glGetHistogramParameteriv(GL_HISTOGRAM, GL_MINMAX_SINK, integers));
}

TEST_F(ImagingState, NothingBetweenBeginAndEnd) {
  GLfloat value[4] = {7, 7, 7, 7};
  glBegin(GL_POINTS);
  glColorTable(GL_COLOR_TABLE, GL_RGBA, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  glBegin(GL_POINTS);
  glHistogram(GL_HISTOGRAM, 4, GL_RGBA, GL_FALSE);
  glEnable(GL_MINMAX);
  glGetColorTableParameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, value);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(value[0], 7);
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 0);
  EXPECT_EQ(histogram(GL_HISTOGRAM, GL_HISTOGRAM_WIDTH), 0);
  EXPECT_EQ(glIsEnabled(GL_MINMAX), GL_FALSE);
}

} // namespace
} // namespace api::imaging
