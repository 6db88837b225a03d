// The errors of ARB_imaging.
#include "imaging.h"

namespace api::imaging {
namespace {

TEST_F(ImagingState, MemoryOfAKnownSize) {
  NEEDS("GL_ARB_robustness");
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
