// The state of ARB_imaging: tables, filters, histograms and minmax tables are set and queried.
#include <algorithm>
#include <iterator>

#include "imaging.h"

namespace api::imaging {
namespace {

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

} // namespace
} // namespace api::imaging
