#pragma once
#include "../fixture.h"
#include "model.h"

namespace api::imaging {

/// Skips tests if ARB_imaging is not offered.
class ImagingTest : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_ARB_imaging");
  }
};

inline GLint levelSize(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetTexLevelParameteriv(target, 0, pname, &value);
  return value;
}

class ImagingState : public ImagingTest {};

inline constexpr GLenum kTables[] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE,
                                     GL_POST_COLOR_MATRIX_COLOR_TABLE};
inline constexpr GLenum kFilters[] = {GL_CONVOLUTION_1D, GL_CONVOLUTION_2D, GL_SEPARABLE_2D};

inline GLint table(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetColorTableParameteriv(target, pname, &value);
  return value;
}
inline GLint filter(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetConvolutionParameteriv(target, pname, &value);
  return value;
}
inline GLint histogram(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetHistogramParameteriv(target, pname, &value);
  return value;
}
inline GLfloat number(GLenum pname) {
  GLfloat value = -1;
  glGetFloatv(pname, &value);
  return value;
}

inline constexpr GLubyte kBytes[] = {10, 20,  30,  40,  50,  60,  70,  80,
                                     90, 100, 110, 120, 130, 140, 150, 160};

/// Returns the level's bytes; it has the image's size.
inline std::vector<GLubyte> texels(GLenum target, const Image &image) {
  std::vector<GLubyte> bytes(std::size_t(image.width * image.height) * 4 + 4);
  glGetTexImage(target, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

} // namespace api::imaging
