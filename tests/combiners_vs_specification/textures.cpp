#include "textures.h"

#include <algorithm>

namespace combined {

using arbiter::fp::combiners::Color;
using arbiter::fp::testing::Random;

namespace {

void plainSampling(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
}

GLuint bindNew(GLenum target) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(target, name);
  plainSampling(target);
  return name;
}

void define(GLenum target, GLenum internal, GLenum format, const GLfloat *texel) {
  switch (target) {
  case GL_TEXTURE_1D:
    return glTexImage1D(target, 0, GLint(internal), 1, 0, format, GL_FLOAT, texel);
  case GL_TEXTURE_3D:
    return glTexImage3D(target, 0, GLint(internal), 1, 1, 1, 0, format, GL_FLOAT, texel);
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GLint(internal), 1, 1, 0, format,
                   GL_FLOAT, texel);
    return;
  default:
    return glTexImage2D(target, 0, GLint(internal), 1, 1, 0, format, GL_FLOAT, texel);
  }
}

/// Returns a color whose components are multiples of 1/255.
Color bytes(Random &random) {
  Color color;
  for (double &c : color)
    c = double(random.below(256)) / 255.0;
  return color;
}

/// Computes a texture register's contents (table RC.2).
Color contentsOf(GLenum internal, const Color &c) {
  switch (internal) {
  case GL_ALPHA8:
    return {0, 0, 0, c[3]};
  case GL_LUMINANCE8:
    return {c[0], c[0], c[0], 1};
  case GL_LUMINANCE8_ALPHA8:
    return {c[0], c[0], c[0], c[3]};
  case GL_INTENSITY8:
    return {c[0], c[0], c[0], c[0]};
  case GL_RGB8:
    return {c[0], c[1], c[2], 1};
  default:
    return c;
  }
}

Texture flat(Random &random, GLenum target, GLenum internal) {
  const Color color = bytes(random);
  Texture texture{bindNew(target), target, contentsOf(internal, color), false};
  const GLfloat texel[] = {GLfloat(color[0]), GLfloat(color[1]), GLfloat(color[2]),
                           GLfloat(color[3])};
  define(target, internal, GL_RGBA, texel);
  return texture;
}

/// Makes a texture of multiples of one half, some below zero.
Texture negativeTexture(Random &random) {
  Texture texture{bindNew(GL_TEXTURE_2D), GL_TEXTURE_2D, {}, false};
  GLfloat texel[4];
  for (std::size_t i = 0; i < 4; ++i)
    texture.contents[i] = double(texel[i] = GLfloat(random.below(257) - 128) / 128.0f);
  define(GL_TEXTURE_2D, GL_RGBA16F, GL_RGBA, texel);
  return texture;
}

/// Makes a depth texture. The mode must not matter (RC: "is irrelevant").
Texture depth(Random &random, GLenum target, GLenum mode, bool compares) {
  const GLfloat value = GLfloat(random.below(65536)) / 65535.0f;
  Texture texture{bindNew(target), target, {0, 0, 0, double(value)}, compares};
  define(target, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, &value);
  glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, GLint(mode));
  if (compares)
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  return texture;
}

} // namespace

std::vector<Texture> makeTextures(bool negative) {
  Random random(0x7E4);
  std::vector<Texture> textures;
  constexpr GLenum kFormats[] = {GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                 GL_INTENSITY8, GL_RGB8,       GL_RGBA8};
  for (const GLenum target :
       {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
    for (const GLenum format : kFormats)
      textures.push_back(flat(random, target, format));
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE})
    for (const GLenum mode : {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA})
      for (const bool compares : {false, true})
        textures.push_back(depth(random, target, mode, compares));
  if (negative)
    textures.push_back(negativeTexture(random));
  return textures;
}

} // namespace combined
