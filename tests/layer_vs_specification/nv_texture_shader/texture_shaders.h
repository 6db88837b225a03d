#pragma once
#include <array>
#include <vector>

#include "../ati_draws.h"
#include "../fixture.h"

/// Shared parts of the tests of NV_texture_shader, 2 and 3.
namespace api::shaders {

/// Skips tests if the extensions are not offered, as on the bare host and under other profiles.
class NvTextureShaders : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_NV_texture_shader3");
  }
};

inline constexpr GLenum kShader = GL_TEXTURE_SHADER_NV;

inline int units() {
  const GLint all = integer(GL_MAX_TEXTURE_UNITS);
  return all < 8 ? all : 8;
}
inline void unit(int number) { glActiveTexture(GLenum(GL_TEXTURE0 + number)); }
inline void operation(GLenum name) { glTexEnvi(kShader, GL_SHADER_OPERATION_NV, GLint(name)); }
inline void previous(int number) {
  glTexEnvi(kShader, GL_PREVIOUS_TEXTURE_INPUT_NV, GL_TEXTURE0 + number);
}
inline GLint value(GLenum pname, GLenum target = kShader) {
  GLint result = -1;
  glGetTexEnviv(target, pname, &result);
  return result;
}
inline std::array<GLfloat, 4> values(GLenum pname) {
  std::array<GLfloat, 4> result = {9, 9, 9, 9};
  glGetTexEnvfv(kShader, pname, result.data());
  return result;
}
inline bool isConsistent(int number) {
  unit(number);
  return value(GL_SHADER_CONSISTENT_NV) == GL_TRUE;
}
inline GLint levelValue(GLenum pname, GLenum target = GL_TEXTURE_2D, GLint level = 0) {
  GLint result = -1;
  glGetTexLevelParameteriv(target, level, pname, &result);
  return result;
}

/// Makes a texture of one texel, bound to GL_TEXTURE_2D of the active unit.
inline GLuint makeTexel(GLenum internal, GLenum format, GLenum type, const void *texel) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(internal), 1, 1, 0, format, type, texel);
  return name;
}

/// Clears, draws everything in that color (if nothing else shades it), and reads the pixel.
inline Pixel drawnIn(GLfloat red, GLfloat green, GLfloat blue) {
  clear();
  glColor4f(red, green, blue, 1);
  glRectf(-1, -1, 1, 1);
  return readPixel();
}

/// Makes a 2x2 texture: red, green below; blue, yellow above.
inline GLuint makeFour() {
  const GLubyte texels[] = {255, 0, 0,   255, 0,   255, 0, 255, //
                            0,   0, 255, 255, 255, 255, 0, 255};
  const GLuint name = makeTexture(GL_TEXTURE_2D, kRedPixel);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  return name;
}

} // namespace api::shaders
