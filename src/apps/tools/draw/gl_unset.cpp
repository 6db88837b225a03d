#include "apps/tools/draw/gl_unset.h"

#include <vector>

#include "apps/scene/texture/unset.h"
#include "apps/tools/draw/gl_queries.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools {

namespace {

using fp::ir::TexTarget;
using scene::Image;

constexpr int kSide = 64; ///< of the tile, in texels

Image imageOf(unsigned unit, GLenum target, int pictureWidth, int pictureHeight) {
  switch (target) {
  case GL_TEXTURE_1D:
    return scene::makeUnset(unit, kSide, 1);
  case GL_TEXTURE_RECTANGLE: // read by texels, usually by the position in the picture
    return scene::makeUnset(unit, pictureWidth, pictureHeight);
  default:
    return scene::makeUnset(unit, kSide, kSide);
  }
}

void uploadDepths(GLenum target, const Image &image) {
  std::vector<float> depths;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      depths.push_back(image.at(x, y).r);
  constexpr GLint kFormat = GL_DEPTH_COMPONENT24;
  if (target == GL_TEXTURE_1D)
    glTexImage1D(target, 0, kFormat, image.width, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  else
    glTexImage2D(target, 0, kFormat, image.width, image.height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 depths.data());
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
}

void uploadColors(GLenum target, const Image &image) {
  const std::vector<std::uint8_t> texels(image.texels.begin(), image.texels.end());
  const auto flat = [&](GLenum face) {
    glTexImage2D(face, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
  };
  switch (target) {
  case GL_TEXTURE_1D:
    glTexImage1D(target, 0, GL_RGBA8, image.width, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    break;
  case GL_TEXTURE_3D:
    glTexImage3D(target, 0, GL_RGBA8, image.width, image.height, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    break;
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      flat(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
    break;
  default:
    flat(target);
  }
}

} // namespace

GLuint makeUnsetTexture(unsigned unit, TexTarget sampled, int pictureWidth, int pictureHeight) {
  const GLenum target = glTarget(sampled);
  const Image image = imageOf(unit, target, pictureWidth, pictureHeight);
  GLuint name = 0;
  glGenTextures(1, &name);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (fp::ir::isShadow(sampled))
    uploadDepths(target, image);
  else
    uploadColors(target, image);
  glBindTexture(target, 0);
  return name;
}

} // namespace arbiter::tools
