#include "fixed_textures.h"

#include <algorithm>

namespace software {

namespace {

constexpr int kSide = 8; // of an image, in texels
constexpr GLenum kTargets[] = {GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_RECTANGLE,
                               GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D};
constexpr GLint kColors[] = {GL_RGBA,  GL_RGB,       GL_LUMINANCE,
                             GL_ALPHA, GL_INTENSITY, GL_LUMINANCE_ALPHA};
constexpr GLint kDepths[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32,
                             GL_DEPTH_COMPONENT32F, GL_DEPTH24_STENCIL8};

/// Returns random bytes for colors, and random 32-bit depths, some of them least and greatest,
/// which a clamped reference equals.
std::vector<std::uint32_t> texelsOf(Random &random, const FixedTexture &texture) {
  std::vector<std::uint32_t> texels(std::size_t(kSide) * kSide * kSide);
  for (std::uint32_t &texel : texels) {
    texel = std::uint32_t(random.bits());
    if (texture.isDepth() && random.once(3))
      texel = random.once(2) ? ~std::uint32_t(0) : 0;
  }
  return texels;
}

void image(GLenum at, int level, const FixedTexture &texture, const std::uint32_t *texels) {
  const bool packed = texture.format == GL_DEPTH24_STENCIL8;
  const GLenum format = packed              ? GLenum(GL_DEPTH_STENCIL)
                        : texture.isDepth() ? GLenum(GL_DEPTH_COMPONENT)
                                            : GLenum(GL_RGBA);
  const GLenum type = packed              ? GLenum(GL_UNSIGNED_INT_24_8)
                      : texture.isDepth() ? GLenum(GL_UNSIGNED_INT)
                                          : GLenum(GL_UNSIGNED_BYTE);
  const int side = kSide >> level;
  if (at == GL_TEXTURE_1D)
    glTexImage1D(at, level, texture.format, side, 0, format, type, texels);
  else if (at == GL_TEXTURE_3D)
    glTexImage3D(at, level, texture.format, side, side, side, 0, format, type, texels);
  else
    glTexImage2D(at, level, texture.format, side, side, 0, format, type, texels + 16 * (at % 6));
}

void setFilters(GLenum target, bool levels, GLint filter) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, levels ? GL_LINEAR_MIPMAP_LINEAR : filter);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
}

} // namespace

bool FixedTexture::isDepth() const {
  return std::find(std::begin(kDepths), std::end(kDepths), format) != std::end(kDepths);
}

FixedTexture makeFixedTexture(Random &random, bool levels) {
  FixedTexture texture;
  texture.target = random.once(2) ? GLenum(GL_TEXTURE_2D) : random.pick(kTargets);
  const bool mayBeDepth = texture.target != GL_TEXTURE_3D;
  texture.format = mayBeDepth && random.once(3) ? random.pick(kDepths) : random.pick(kColors);
  const GLenum target = texture.target;
  glGenTextures(1, &texture.name);
  glBindTexture(target, texture.name);
  const bool hasLevels = levels && target != GL_TEXTURE_RECTANGLE;
  for (int level = 0; level < (hasLevels ? 4 : 1); ++level) {
    const std::vector<std::uint32_t> texels = texelsOf(random, texture);
    if (target == GL_TEXTURE_CUBE_MAP)
      for (GLenum face = 0; face < 6; ++face)
        image(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, texture, texels.data());
    else
      image(target, level, texture, texels.data());
    if (!texture.isDepth())
      break; // levels of colors are generated
  }
  if (hasLevels && !texture.isDepth())
    glGenerateMipmap(target);
  // The filter is linear, as it is then continuous at a border between two texels.
  setFilters(target, hasLevels, GL_LINEAR);
  constexpr GLint kWraps[] = {GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_REPEAT, GL_MIRRORED_REPEAT};
  const int wraps = target == GL_TEXTURE_RECTANGLE ? 2 : 4;
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(target, name, kWraps[random.below(wraps)]);
  float border[4];
  for (float &component : border)
    component = float(random.below(9)) / 8;
  glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border);
  return texture;
}

void chooseComparison(Random &random, const FixedTexture &texture, bool levels) {
  if (!texture.isDepth())
    return;
  const GLenum target = texture.target;
  // A cube map has no component left for a reference, and for 1D textures Mesa 22.3.6 uses t
  // (compared.cpp).
  const bool compares =
      (target == GL_TEXTURE_2D || target == GL_TEXTURE_RECTANGLE) && !random.once(4);
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
  glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_NEVER + random.below(8));
  constexpr GLint kModes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED};
  // glPopAttrib of Mesa 22.3.6 restores the mode but not its effect, and setting the same mode
  // changes nothing, so that each mode is set in turn.
  for (const GLint mode : kModes)
    glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, mode);
  glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, random.pick(kModes));
  const bool hasLevels = levels && target != GL_TEXTURE_RECTANGLE;
  setFilters(target, hasLevels, !hasLevels && random.once(2) ? GL_NEAREST : GL_LINEAR);
}

} // namespace software
