#pragma once
#include "../fixture.h"
#include "model.h"

namespace api::imaging {

/// Skips where ARB_imaging is not offered.
class ImagingTest : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    if (!epoxy_has_gl_extension("GL_ARB_imaging"))
      GTEST_SKIP() << "GL_ARB_imaging is not offered here";
  }
};

inline GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}

inline GLint levelSize(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetTexLevelParameteriv(target, 0, pname, &value);
  return value;
}

/// The level's bytes, which the image has the size of.
inline std::vector<GLubyte> texels(GLenum target, const Image &image) {
  std::vector<GLubyte> bytes(std::size_t(image.width * image.height) * 4 + 4);
  glGetTexImage(target, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

} // namespace api::imaging
