// The earlier names of ARB_imaging's commands: those of SGI_color_table, EXT_color_subtable,
// EXT_convolution and EXT_histogram. All act on the same state.
#include <algorithm>
#include <iterator>

#include "imaging.h"

namespace api::imaging {
namespace {

#define API_OLD_NAMES(X)                                                                           \
  X(ColorTableEXT, (GLenum, GLenum, GLsizei, GLenum, GLenum, const void *))                        \
  X(ColorTableSGI, (GLenum, GLenum, GLsizei, GLenum, GLenum, const void *))                        \
  X(ColorSubTableEXT, (GLenum, GLsizei, GLsizei, GLenum, GLenum, const void *))                    \
  X(ColorTableParameterfvSGI, (GLenum, GLenum, const GLfloat *))                                   \
  X(ColorTableParameterivSGI, (GLenum, GLenum, const GLint *))                                     \
  X(GetColorTableEXT, (GLenum, GLenum, GLenum, void *))                                            \
  X(GetColorTableSGI, (GLenum, GLenum, GLenum, void *))                                            \
  X(GetColorTableParameterfvEXT, (GLenum, GLenum, GLfloat *))                                      \
  X(GetColorTableParameterfvSGI, (GLenum, GLenum, GLfloat *))                                      \
  X(GetColorTableParameterivEXT, (GLenum, GLenum, GLint *))                                        \
  X(GetColorTableParameterivSGI, (GLenum, GLenum, GLint *))                                        \
  X(CopyColorTableSGI, (GLenum, GLenum, GLint, GLint, GLsizei))                                    \
  X(CopyColorSubTableEXT, (GLenum, GLsizei, GLint, GLint, GLsizei))                                \
  X(ConvolutionFilter1DEXT, (GLenum, GLenum, GLsizei, GLenum, GLenum, const void *))               \
  X(ConvolutionFilter2DEXT, (GLenum, GLenum, GLsizei, GLsizei, GLenum, GLenum, const void *))      \
  X(SeparableFilter2DEXT,                                                                          \
    (GLenum, GLenum, GLsizei, GLsizei, GLenum, GLenum, const void *, const void *))                \
  X(CopyConvolutionFilter1DEXT, (GLenum, GLenum, GLint, GLint, GLsizei))                           \
  X(CopyConvolutionFilter2DEXT, (GLenum, GLenum, GLint, GLint, GLsizei, GLsizei))                  \
  X(ConvolutionParameteriEXT, (GLenum, GLenum, GLint))                                             \
  X(ConvolutionParameterfvEXT, (GLenum, GLenum, const GLfloat *))                                  \
  X(GetConvolutionFilterEXT, (GLenum, GLenum, GLenum, void *))                                     \
  X(GetSeparableFilterEXT, (GLenum, GLenum, GLenum, void *, void *, void *))                       \
  X(GetConvolutionParameterfvEXT, (GLenum, GLenum, GLfloat *))                                     \
  X(GetConvolutionParameterivEXT, (GLenum, GLenum, GLint *))                                       \
  X(HistogramEXT, (GLenum, GLsizei, GLenum, GLboolean))                                            \
  X(ResetHistogramEXT, (GLenum))                                                                   \
  X(GetHistogramEXT, (GLenum, GLboolean, GLenum, GLenum, void *))                                  \
  X(GetHistogramParameterfvEXT, (GLenum, GLenum, GLfloat *))                                       \
  X(GetHistogramParameterivEXT, (GLenum, GLenum, GLint *))                                         \
  X(MinmaxEXT, (GLenum, GLenum, GLboolean))                                                        \
  X(ResetMinmaxEXT, (GLenum))                                                                      \
  X(GetMinmaxEXT, (GLenum, GLboolean, GLenum, GLenum, void *))                                     \
  X(GetMinmaxParameterfvEXT, (GLenum, GLenum, GLfloat *))                                          \
  X(GetMinmaxParameterivEXT, (GLenum, GLenum, GLint *))

/// Finds the functions by eglGetProcAddress, as libepoxy checks for extensions that are not
/// announced.
class ImagingNames : public ImagingTest {
protected:
#define API_POINTER(name, parameters) void(*name) parameters = nullptr;
  API_OLD_NAMES(API_POINTER)
#undef API_POINTER

  void SetUp() override {
    ImagingTest::SetUp();
#define API_LOOK_UP(name, parameters)                                                              \
  name = reinterpret_cast<void(*) parameters>(eglGetProcAddress("gl" #name));                      \
  ASSERT_TRUE(name) << #name;
    API_OLD_NAMES(API_LOOK_UP)
#undef API_LOOK_UP
  }
};

using Bytes = std::array<GLubyte, 16>;

TEST_F(ImagingNames, TablesAreTheSame) {
  for (const auto give : {ColorTableEXT, ColorTableSGI}) {
    for (const auto take : {GetColorTableEXT, GetColorTableSGI}) {
      glColorTable(GL_COLOR_TABLE, GL_RGB8, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes + 4);
      EXPECT_NO_GL_ERROR(give(GL_COLOR_TABLE, GL_RGBA8, 4, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
      Bytes read{};
      EXPECT_NO_GL_ERROR(take(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read.data()));
      EXPECT_TRUE(std::equal(read.begin(), read.end(), kBytes));
      EXPECT_GL_ERROR(GL_INVALID_ENUM, take(GL_HISTOGRAM, GL_RGBA, GL_UNSIGNED_BYTE, read.data()));
    }
  }
  EXPECT_NO_GL_ERROR(ColorSubTableEXT(GL_COLOR_TABLE, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes));
  Bytes read{};
  glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  EXPECT_EQ(read[4], 10);
  EXPECT_EQ(read[8], 90);
  for (const auto take : {GetColorTableParameterivEXT, GetColorTableParameterivSGI}) {
    GLint value = -1;
    EXPECT_NO_GL_ERROR(take(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &value));
    EXPECT_EQ(value, 4);
  }
  const GLfloat scale[] = {2, 1, 0.5f, 1};
  const GLint bias[] = {0, 1, 0, -1};
  ColorTableParameterfvSGI(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, scale);
  ColorTableParameterivSGI(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, bias);
  for (const auto take : {GetColorTableParameterfvEXT, GetColorTableParameterfvSGI}) {
    GLfloat values[4] = {};
    EXPECT_NO_GL_ERROR(take(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, values));
    EXPECT_TRUE(std::equal(std::begin(values), std::end(values), scale));
    take(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, values);
    EXPECT_TRUE(std::equal(std::begin(values), std::end(values), bias));
  }
}

TEST_F(ImagingNames, CopiesAreTheSame) {
  glWindowPos2i(0, 0);
  glDrawPixels(4, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  Bytes read{};
  CopyColorTableSGI(GL_COLOR_TABLE, GL_RGBA8, 0, 0, 4);
  CopyColorSubTableEXT(GL_COLOR_TABLE, 2, 0, 0, 1);
  GetColorTableSGI(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  EXPECT_EQ(read[4], 50);
  EXPECT_EQ(read[8], 10);
  CopyConvolutionFilter1DEXT(GL_CONVOLUTION_1D, GL_RGBA, 0, 0, 3);
  GetConvolutionFilterEXT(GL_CONVOLUTION_1D, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  EXPECT_EQ(read[8], 90);
  CopyConvolutionFilter2DEXT(GL_CONVOLUTION_2D, GL_RGBA, 1, 0, 2, 1);
  GetConvolutionFilterEXT(GL_CONVOLUTION_2D, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  EXPECT_EQ(read[0], 50);
}

TEST_F(ImagingNames, FiltersAreTheSame) {
  const GLfloat weights[] = {-2, 0.5f, 3, 1, 0.25f, 8, 0, -1, 4, 5, 6, 7};
  GLfloat read[12] = {};
  ConvolutionFilter1DEXT(GL_CONVOLUTION_1D, GL_RGBA, 3, GL_RGBA, GL_FLOAT, weights);
  EXPECT_NO_GL_ERROR(GetConvolutionFilterEXT(GL_CONVOLUTION_1D, GL_RGBA, GL_FLOAT, read));
  EXPECT_TRUE(std::equal(std::begin(read), std::end(read), weights));
  ConvolutionFilter2DEXT(GL_CONVOLUTION_2D, GL_LUMINANCE, 2, 2, GL_LUMINANCE, GL_FLOAT, weights);
  EXPECT_NO_GL_ERROR(GetConvolutionFilterEXT(GL_CONVOLUTION_2D, GL_LUMINANCE, GL_FLOAT, read));
  EXPECT_TRUE(std::equal(read, read + 4, weights));
  SeparableFilter2DEXT(GL_SEPARABLE_2D, GL_LUMINANCE, 2, 3, GL_LUMINANCE, GL_FLOAT, weights,
                       weights + 4);
  GLfloat row[2] = {}, column[3] = {};
  EXPECT_NO_GL_ERROR(
      GetSeparableFilterEXT(GL_SEPARABLE_2D, GL_LUMINANCE, GL_FLOAT, row, column, nullptr));
  EXPECT_EQ(row[1], 0.5f);
  EXPECT_EQ(column[1], 8);
  GLint size = -1;
  EXPECT_NO_GL_ERROR(GetConvolutionParameterivEXT(GL_SEPARABLE_2D, GL_CONVOLUTION_HEIGHT, &size));
  EXPECT_EQ(size, 3);
  const GLfloat scale[] = {2, 1, 0.5f, 4};
  ConvolutionParameterfvEXT(GL_CONVOLUTION_2D, GL_CONVOLUTION_FILTER_SCALE, scale);
  GLfloat values[4] = {};
  EXPECT_NO_GL_ERROR(
      GetConvolutionParameterfvEXT(GL_CONVOLUTION_2D, GL_CONVOLUTION_FILTER_SCALE, values));
  EXPECT_TRUE(std::equal(std::begin(values), std::end(values), scale));
  ConvolutionParameteriEXT(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_MODE, GL_CONSTANT_BORDER);
  EXPECT_EQ(filter(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_MODE), GL_CONSTANT_BORDER);
}

TEST_F(ImagingNames, StatisticsAreTheSame) {
  HistogramEXT(GL_HISTOGRAM, 2, GL_RGB, GL_FALSE);
  MinmaxEXT(GL_MINMAX, GL_RGBA, GL_FALSE);
  GLint format = -1;
  GLfloat width = -1;
  EXPECT_NO_GL_ERROR(GetHistogramParameterivEXT(GL_HISTOGRAM, GL_HISTOGRAM_FORMAT, &format));
  EXPECT_EQ(format, GL_RGB);
  EXPECT_NO_GL_ERROR(GetHistogramParameterfvEXT(GL_HISTOGRAM, GL_HISTOGRAM_WIDTH, &width));
  EXPECT_EQ(width, 2);
  EXPECT_NO_GL_ERROR(GetMinmaxParameterivEXT(GL_MINMAX, GL_MINMAX_FORMAT, &format));
  EXPECT_EQ(format, GL_RGBA);
  EXPECT_NO_GL_ERROR(GetMinmaxParameterfvEXT(GL_MINMAX, GL_MINMAX_SINK, &width));
  EXPECT_EQ(width, 0);
  glEnable(GL_HISTOGRAM);
  glEnable(GL_MINMAX);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
  glDisable(GL_HISTOGRAM);
  glDisable(GL_MINMAX);
  GLuint bins[2] = {};
  EXPECT_NO_GL_ERROR(GetHistogramEXT(GL_HISTOGRAM, GL_TRUE, GL_RED, GL_UNSIGNED_INT, bins));
  EXPECT_EQ(bins[0], 3u) << "10, 50, 90";
  EXPECT_EQ(bins[1], 1u) << "130";
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_RED, GL_UNSIGNED_INT, bins);
  EXPECT_EQ(bins[0] + bins[1], 0u) << "was reset";
  GLubyte ends[8] = {};
  EXPECT_NO_GL_ERROR(GetMinmaxEXT(GL_MINMAX, GL_FALSE, GL_RGBA, GL_UNSIGNED_BYTE, ends));
  EXPECT_EQ(ends[0], 10);
  EXPECT_EQ(ends[4], 130);
  ResetMinmaxEXT(GL_MINMAX);
  GLfloat least[8] = {};
  glGetMinmax(GL_MINMAX, GL_FALSE, GL_RGBA, GL_FLOAT, least);
  EXPECT_GT(least[0], least[4]) << "was reset";
  glGetHistogram(GL_HISTOGRAM, GL_FALSE, GL_GREEN, GL_UNSIGNED_INT, bins);
  EXPECT_EQ(bins[0], 3u);
  ResetHistogramEXT(GL_HISTOGRAM);
  GetHistogramEXT(GL_HISTOGRAM, GL_FALSE, GL_GREEN, GL_UNSIGNED_INT, bins);
  EXPECT_EQ(bins[0], 0u);
}

} // namespace
} // namespace api::imaging
