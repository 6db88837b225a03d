#pragma once
#include "ati_shader.h"

/// Shared parts of the tests of drawing with ATI_fragment_shader.
namespace api {

inline constexpr GLuint kReg0 = GL_REG_0_ATI;
inline constexpr GLuint kReg1 = GL_REG_1_ATI;
inline constexpr Pixel kYellow = {255, 255, 0, 255};
inline constexpr Pixel kOpaqueBlack = {0, 0, 0, 255};

/// Compares colors of 8 bits; paths may round differently.
inline void expectNear(const Pixel &got, const Pixel &want, int tolerance = 2) {
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(got[i], want[i], tolerance) << "component " << i;
}

class AtiDraws : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    glEnable(GL_FRAGMENT_SHADER_ATI);
    ati::constant(GL_CON_0_ATI, 1, 0, 0, 1);
    ati::constant(GL_CON_1_ATI, 0, 1, 0, 1);
    ati::constant(GL_CON_2_ATI, 0.2f, 0.4f, 0.6f, 0.8f);
  }
};

/// Makes a complete texture of one color for `target`, bound to the active unit.
inline GLuint makeTexture(GLenum target, const Pixel &color) {
  const GLubyte texel[] = {GLubyte(color[0]), GLubyte(color[1]), GLubyte(color[2]),
                           GLubyte(color[3])};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(target, name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  switch (target) {
  case GL_TEXTURE_1D:
    glTexImage1D(target, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    break;
  case GL_TEXTURE_3D:
    glTexImage3D(target, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    break;
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, texel);
    break;
  default:
    glTexImage2D(target, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  }
  return name;
}

/// Clears, calls a list that draws both halves of the window, and compares them.
inline void expectHalves(GLuint list, const Pixel &left, const Pixel &right) {
  clear();
  glCallList(list);
  expectNear(readPixel(4), left);
  expectNear(readPixel(28), right);
}

/// Calls `draws(name of the command, function that binds a 2D texture)` for each command that binds
/// to the unit, which is the active one.
template <typename Draws> void forEachBinding(GLuint unit, const Draws &draws) {
  draws("BindTexture", [](GLuint name) { glBindTexture(GL_TEXTURE_2D, name); });
  if (epoxy_has_gl_extension("GL_ARB_multi_bind"))
    draws("BindTextures", [=](GLuint name) { glBindTextures(unit, 1, &name); });
  if (epoxy_has_gl_extension("GL_ARB_direct_state_access"))
    draws("BindTextureUnit", [=](GLuint name) { glBindTextureUnit(unit, name); });
  if (epoxy_has_gl_extension("GL_EXT_direct_state_access"))
    draws("BindMultiTextureEXT",
          [=](GLuint name) { glBindMultiTextureEXT(GL_TEXTURE0 + unit, GL_TEXTURE_2D, name); });
}

/// Makes a shader that samples unit 0 at its coordinates and outputs the sample.
inline void makeSamplingShader() {
  ati::makeShader([] {
    ati::sample(kReg0, GL_TEXTURE0);
    ati::moveAll(kReg0);
  });
}

} // namespace api
