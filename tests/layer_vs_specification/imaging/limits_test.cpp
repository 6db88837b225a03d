// Sizes and formats of ARB_imaging's tables and filters at their limits, and beyond (OpenGL 2.1,
// 3.6.3 and 6.1.7 to 6.1.10).
#include <algorithm>
#include <cmath>

#include "imaging.h"

namespace api::imaging {
namespace {

/// Returns the greatest width that a proxy accepts.
GLsizei greatestTable() {
  GLsizei width = 1;
  for (GLsizei next = 2; next <= 1 << 24; next *= 2) {
    glColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA8, next, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    if (table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH) == next)
      width = next;
  }
  return width;
}

/// A size that a proxy accepts works, and one that it refuses is too large: the proxy's state is
/// then zero, and the table stays.
TEST_F(ImagingState, AProxySaysWhatATableMayBe) {
  const GLsizei most = greatestTable();
  EXPECT_GE(most, 256);
  const std::vector<GLubyte> bytes(std::size_t(most) * 8, 77);
  for (std::size_t i = 0; i < 3; ++i) {
    const GLenum proxy = GL_PROXY_COLOR_TABLE + GLenum(i);
    EXPECT_NO_GL_ERROR(
        glColorTable(kTables[i], GL_RGBA8, most, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data()));
    EXPECT_GL_ERROR(GL_TABLE_TOO_LARGE, glColorTable(kTables[i], GL_RGBA8, most * 2, GL_RGBA,
                                                     GL_UNSIGNED_BYTE, bytes.data()));
    EXPECT_EQ(table(kTables[i], GL_COLOR_TABLE_WIDTH), most);
    glColorTable(proxy, GL_LUMINANCE12_ALPHA4, 64, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(table(proxy, GL_COLOR_TABLE_FORMAT), GL_LUMINANCE12_ALPHA4);
    EXPECT_EQ(table(proxy, GL_COLOR_TABLE_LUMINANCE_SIZE), 12);
    EXPECT_EQ(table(proxy, GL_COLOR_TABLE_ALPHA_SIZE), 4);
    EXPECT_NO_GL_ERROR(glColorTable(proxy, GL_RGBA8, most * 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr));
    for (const GLenum pname : {GL_COLOR_TABLE_FORMAT, GL_COLOR_TABLE_WIDTH, GL_COLOR_TABLE_RED_SIZE,
                               GL_COLOR_TABLE_ALPHA_SIZE, GL_COLOR_TABLE_LUMINANCE_SIZE})
      EXPECT_EQ(table(proxy, pname), 0) << pname;
    EXPECT_NO_GL_ERROR(glColorTable(kTables[i], GL_RGBA, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr));
    EXPECT_EQ(table(kTables[i], GL_COLOR_TABLE_WIDTH), 0) << "of no width it is none";
  }
  glHistogram(GL_PROXY_HISTOGRAM, most, GL_LUMINANCE_ALPHA, GL_TRUE);
  EXPECT_EQ(histogram(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH), most);
  EXPECT_GT(histogram(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_LUMINANCE_SIZE), 0);
  EXPECT_NO_GL_ERROR(glHistogram(GL_PROXY_HISTOGRAM, 1 << 24, GL_RGBA, GL_TRUE));
  for (const GLenum pname :
       {GL_HISTOGRAM_WIDTH, GL_HISTOGRAM_FORMAT, GL_HISTOGRAM_RED_SIZE, GL_HISTOGRAM_ALPHA_SIZE})
    EXPECT_EQ(histogram(GL_PROXY_HISTOGRAM, pname), 0) << pname;
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glHistogram(GL_PROXY_HISTOGRAM, 3, GL_RGBA, GL_FALSE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glHistogram(GL_PROXY_HISTOGRAM, 4, GL_INTENSITY, GL_FALSE));
}

/// A proxy only checks sizes; all other errors are raised for it too, and leave it unchanged.
TEST_F(ImagingState, AProxyHasTheOtherErrors) {
  glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 16, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTable(GL_PROXY_COLOR_TABLE, GL_RED, 8, GL_RGB, GL_UNSIGNED_BYTE, nullptr));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 8,
                                                GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, nullptr));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 8, GL_COLOR_INDEX,
                                                GL_UNSIGNED_BYTE, nullptr));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 8, GL_RGB, GL_LINEAR, nullptr));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 8, GL_RGBA,
                                                     GL_UNSIGNED_SHORT_5_6_5, nullptr));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 3, GL_RGB,
                                                 GL_UNSIGNED_BYTE, nullptr));
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 16);
}

/// An invalid copy is an error before the framebuffer is read; a proxy has no copies.
TEST_F(ImagingState, CopiesOfTables) {
  glColorTable(GL_PROXY_COLOR_TABLE, GL_RGB8, 16, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCopyColorTable(GL_PROXY_COLOR_TABLE, GL_RGBA8, 0, 0, 4));
  EXPECT_EQ(table(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 16);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCopyColorTable(GL_COLOR_TABLE, GL_RED, 0, 0, 4));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCopyColorTable(GL_COLOR_TABLE, GL_RGBA8, 0, 0, 3));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCopyColorTable(GL_COLOR_TABLE, GL_RGBA8, 0, 0, -4));
  EXPECT_GL_ERROR(GL_TABLE_TOO_LARGE, glCopyColorTable(GL_COLOR_TABLE, GL_RGBA8, 0, 0, 1 << 28));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCopyColorSubTable(GL_PROXY_COLOR_TABLE, 0, 0, 0, 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glCopyColorSubTable(GL_COLOR_TABLE, 0, 0, 0, 1 << 28));
  EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_WIDTH), 0);
}

TEST_F(ImagingState, FiltersOfTheGreatestSize) {
  EXPECT_EQ(filter(GL_CONVOLUTION_1D, GL_MAX_CONVOLUTION_HEIGHT), 1);
  for (const GLenum target : {GL_CONVOLUTION_2D, GL_SEPARABLE_2D})
    EXPECT_GE(filter(target, GL_MAX_CONVOLUTION_HEIGHT), 3);
  const GLint width = filter(GL_CONVOLUTION_2D, GL_MAX_CONVOLUTION_WIDTH),
              height = filter(GL_CONVOLUTION_2D, GL_MAX_CONVOLUTION_HEIGHT);
  const std::vector<GLubyte> bytes(std::size_t(width + 1) * std::size_t(height + 1) * 4, 255);
  EXPECT_NO_GL_ERROR(glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, width, height, GL_RGBA,
                                           GL_UNSIGNED_BYTE, bytes.data()));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, width + 1, height, GL_RGBA,
                                        GL_UNSIGNED_BYTE, bytes.data()));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, width, height + 1, GL_RGBA,
                                        GL_UNSIGNED_BYTE, bytes.data()));
  EXPECT_EQ(filter(GL_CONVOLUTION_2D, GL_CONVOLUTION_HEIGHT), height);
  EXPECT_NO_GL_ERROR(glSeparableFilter2D(GL_SEPARABLE_2D, GL_RGBA, width, height, GL_RGBA,
                                         GL_UNSIGNED_BYTE, bytes.data(), bytes.data()));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glSeparableFilter2D(GL_SEPARABLE_2D, GL_RGBA, width, height + 1, GL_RGBA,
                                      GL_UNSIGNED_BYTE, bytes.data(), bytes.data()));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glCopyConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 0, 0, width + 1));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glCopyConvolutionFilter2D(GL_CONVOLUTION_2D, GL_RGBA, 0, 0, 1, -1));
}

/// An invalid type is an error even if there is nothing to convert.
TEST_F(ImagingState, NothingIsOfNoType) {
  const auto wrong = [](GLenum error, auto call) { EXPECT_GL_ERROR(error, call()); };
  GLubyte read[16] = {};
  wrong(GL_INVALID_ENUM,
        [&] { glColorTable(GL_COLOR_TABLE, GL_RGBA, 0, GL_RGBA, GL_LINEAR, nullptr); });
  wrong(GL_INVALID_OPERATION, [&] {
    glColorTable(GL_COLOR_TABLE, GL_RGBA, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, nullptr);
  });
  wrong(GL_INVALID_ENUM,
        [&] { glConvolutionFilter1D(GL_CONVOLUTION_1D, GL_RGBA, 0, GL_RGBA, GL_LINEAR, nullptr); });
  glColorTable(GL_COLOR_TABLE, GL_RGBA, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  wrong(GL_INVALID_ENUM, [&] { glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_LINEAR, read); });
  wrong(GL_INVALID_OPERATION,
        [&] { glGetColorTable(GL_COLOR_TABLE, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, read); });
  EXPECT_NO_GL_ERROR(glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_UNSIGNED_BYTE, read));
  EXPECT_TRUE(std::all_of(read, read + 16, [](GLubyte b) { return b == 0; }));
}

/// Each format has its bits, and keeps certain components of a color: a table rounds to them, a
/// filter does not.
TEST_F(ImagingState, EveryFormatHasItsBits) {
  struct Row {
    GLenum format;
    GLint red, green, blue, alpha, luminance, intensity;
  };
  constexpr Row kRows[] = {{GL_R3_G3_B2, 3, 3, 2, 0, 0, 0},
                           {GL_RGB5_A1, 5, 5, 5, 1, 0, 0},
                           {GL_RGB10_A2, 10, 10, 10, 2, 0, 0},
                           {GL_RGBA2, 2, 2, 2, 2, 0, 0},
                           {GL_ALPHA4, 0, 0, 0, 4, 0, 0},
                           {GL_LUMINANCE4, 0, 0, 0, 0, 4, 0},
                           {GL_LUMINANCE6_ALPHA2, 0, 0, 0, 2, 6, 0},
                           {GL_INTENSITY12, 0, 0, 0, 0, 0, 12}};
  const GLfloat color[] = {0.4f, 0.4f, 0.4f, 0.4f};
  for (const Row &row : kRows) {
    glColorTable(GL_COLOR_TABLE, row.format, 1, GL_RGBA, GL_FLOAT, color);
    const GLint bits[] = {row.red, row.green, row.blue, row.alpha, row.luminance, row.intensity};
    for (GLenum i = 0; i < 6; ++i)
      EXPECT_EQ(table(GL_COLOR_TABLE, GL_COLOR_TABLE_RED_SIZE + i), bits[i]) << row.format << i;
    GLfloat read[4] = {};
    glGetColorTable(GL_COLOR_TABLE, GL_RGBA, GL_FLOAT, read);
    const GLint first = std::max({row.red, row.luminance, row.intensity});
    const auto rounded = [](GLint of) {
      const auto steps = float((1 << of) - 1);
      return std::floor(0.4f * steps + 0.5f) / steps;
    };
    if (first != 0) {
      EXPECT_NEAR(read[0], rounded(first), 1e-6) << row.format;
    }
    if (row.alpha != 0) {
      EXPECT_NEAR(read[3], rounded(row.alpha), 1e-6) << row.format;
    }
  }
}

} // namespace
} // namespace api::imaging
