// Texels that the application uploads.
#include <cstring>

#include "state/residency/residency_host.h"

namespace arbiter::state {

namespace {

using abi::From;
using swrast::Image;
using swrast::Rect;

/// An application's pixel format of whole bytes (OpenGL 1.4, table 3.6), and where it has R, G, B
/// and A.
struct ByteSource {
  int bytes = 0; ///< per pixel
  abi::Swizzle rgba = abi::kRgba;
};

bool byteSource(GLenum format, GLenum type, ByteSource &out) {
  constexpr From kZero = From::Zero, kOne = From::One;
  constexpr From a = From::C0, b = From::C1, c = From::C2, d = From::C3;
  const bool four = format == GL_RGBA || format == GL_BGRA;
  const bool packed = type == GL_UNSIGNED_INT_8_8_8_8; // the first component is the highest byte
  if (type != GL_UNSIGNED_BYTE && !(four && (packed || type == GL_UNSIGNED_INT_8_8_8_8_REV)))
    return false;
  switch (format) {
  case GL_RGBA:
    out = {4, packed ? abi::Swizzle{d, c, b, a} : abi::kRgba};
    return true;
  case GL_BGRA:
    out = {4, packed ? abi::Swizzle{b, c, d, a} : abi::Swizzle{c, b, a, d}};
    return true;
  case GL_RGB:
    out = {3, {a, b, c, kOne}};
    return true;
  case GL_BGR:
    out = {3, {c, b, a, kOne}};
    return true;
  case GL_RED:
    out = {1, {a, kZero, kZero, kOne}};
    return true;
  case GL_GREEN:
    out = {1, {kZero, a, kZero, kOne}};
    return true;
  case GL_BLUE:
    out = {1, {kZero, kZero, a, kOne}};
    return true;
  case GL_ALPHA:
    out = {1, {kZero, kZero, kZero, a}};
    return true;
  case GL_RG:
    out = {2, {a, b, kZero, kOne}};
    return true;
  case GL_LUMINANCE:
    out = {1, {a, a, a, kOne}};
    return true;
  case GL_LUMINANCE_ALPHA:
    out = {2, {a, a, a, b}};
    return true;
  default:
    return false;
  }
}

/// For each stored byte of a texel: the byte of the source pixel, or one of these constants.
constexpr int kZeroByte = -1, kFullByte = -2;
struct Plan {
  int bytes = 0, stored = 0;
  int from[4] = {kFullByte, kFullByte, kFullByte, kFullByte};
};

/// Makes a plan. Returns false if the source cannot be written to the format bytewise.
bool planOf(const ByteSource &source, GLenum base, const abi::Format &format, Plan &plan) {
  abi::Format view;
  if (!viewAs({abi::Layout::U8x4, source.rgba}, base, format, view))
    return false;
  plan.bytes = source.bytes;
  plan.stored = abi::bytesOf(format.layout);
  for (std::size_t i = 0; i < 4; ++i) {
    const From to = format.swizzle[i], from = view.swizzle[i];
    if (to <= From::C3)
      plan.from[int(to)] = from <= From::C3     ? int(from)
                           : from == From::Zero ? kZeroByte
                                                : kFullByte;
  }
  return true;
}

void writeRow(const Plan &plan, const std::uint8_t *from, std::uint8_t *to, int count) {
  const int *const f = plan.from;
  const bool four = plan.stored == 4 && f[1] == 1;
  if (plan.bytes == plan.stored) {
    bool straight = true;
    for (int i = 0; i < plan.stored; ++i)
      straight = straight && (f[i] == i || (f[i] == kFullByte && i == 3));
    if (straight) { // a fourth byte that is never sampled may hold anything
      std::memcpy(to, from, std::size_t(count) * std::size_t(plan.bytes));
      return;
    }
  }
  if (four && plan.bytes == 4 && f[0] == 2 && f[2] == 0 && (f[3] == 3 || f[3] == kFullByte)) {
    for (int x = 0; x < count; ++x) {
      std::uint32_t v;
      std::memcpy(&v, from + 4 * x, 4);
      v = (v & 0xFF00FF00u) | (v >> 16 & 0xFFu) | (v & 0xFFu) << 16;
      std::memcpy(to + 4 * x, &v, 4);
    }
    return;
  }
  if (four && plan.bytes == 3 && f[3] == kFullByte &&
      ((f[0] == 0 && f[2] == 2) || (f[0] == 2 && f[2] == 0))) {
    const int first = f[0], third = f[2];
    for (int x = 0; x < count; ++x, from += 3) {
      const std::uint32_t v = from[first] | std::uint32_t(from[1]) << 8 |
                              std::uint32_t(from[third]) << 16 | 0xFF000000u;
      std::memcpy(to + 4 * x, &v, 4);
    }
    return;
  }
  for (int x = 0; x < count; ++x, from += plan.bytes, to += plan.stored)
    for (int i = 0; i < plan.stored; ++i)
      to[i] = f[i] >= 0 ? from[f[i]] : f[i] == kZeroByte ? 0 : 0xFF;
}

/// The address of the first pixel, and the bytes from row to row (3.6.4).
struct SourceRows {
  const std::uint8_t *data = nullptr;
  std::int64_t stride = 0;
};
SourceRows rowsOf(const PixelModes::Store &unpack, int bytes, GLsizei width, const void *pixels) {
  const std::int64_t row = unpack.rowLength > 0 ? unpack.rowLength : width;
  SourceRows rows;
  rows.stride = (row * bytes + unpack.alignment - 1) / unpack.alignment * unpack.alignment;
  rows.data = static_cast<const std::uint8_t *>(pixels) + unpack.skipRows * rows.stride +
              std::int64_t(unpack.skipPixels) * bytes;
  return rows;
}

/// Makes the shadow writable. If all of it is replaced, it takes the source's order of components,
/// so that rows are just copied.
bool writableShadow(ResidentImages &images, PixelImage &image, const ByteSource &source,
                    bool whole) {
  abi::Format order = image.shadow.format;
  if (whole && source.bytes == 4 && image.format.layout == abi::Layout::U8x4 &&
      viewAs({abi::Layout::U8x4, source.rgba}, image.base, image.format, order) &&
      writable(order, image.format) && order != image.shadow.format) {
    image.shadow.format = order;
    image.shadow.storage.reset();
  }
  images.objects.changed();
  return makeOwn(images, image, !whole);
}

/// Writes texels to the shadow of one level and face. Returns false if the formats are not plain.
bool write(ResidentImages &images, PixelImage &image, const Rect &to, GLenum format, GLenum type,
           const void *pixels) {
  ByteSource source;
  const PixelModes &modes = pixelModes(images);
  if (!pixels || image.base == 0 || image.depth != 1 || !byteSource(format, type, source) ||
      modes.transfers || modes.unpack.buffer != 0 || modes.unpack.swapBytes != 0)
    return false;
  // If the host refuses the command, the texels stay unchanged.
  if (to.x < 0 || to.y < 0 || to.empty() || to.width > image.width - to.x ||
      to.height > image.height - to.y)
    return false;
  Plan plan;
  const bool whole = to.width == image.width && to.height == image.height;
  if (!planOf(source, image.base, image.format, plan) ||
      !writableShadow(images, image, source, whole) ||
      !planOf(source, image.base, image.shadow.format, plan))
    return false;
  const SourceRows rows = rowsOf(modes.unpack, source.bytes, to.width, pixels);
  for (int y = 0; y < to.height; ++y)
    writeRow(plan, rows.data + y * rows.stride, image.shadow.pixel(to.x, to.y + y), to.width);
  if (whole)
    setValid(images, image, Valid::Both);
  return true;
}

} // namespace

void Residency::texSubImage(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                            GLsizei height, GLsizei, GLenum format, GLenum type,
                            const void *pixels) {
  ResidentImages &images = *m_images;
  const GLenum binding = bindingOf(target);
  if (!isAlone(images) || binding == 0)
    return;
  ObjectImages &objects = images.objects;
  if (objects.shadowed.empty())
    return;
  Texture *const texture = textureOfBoundName(images, target);
  if (!texture)
    return;
  if (makesMipmaps(images, target))
    return textureRedefined(textureTargetOf(target));
  PixelImage *const image = levelOf(images, *texture, target, level);
  if (!image || image->valid == Valid::Host ||
      (z == 0 && isNamedAsBound(images, texture->name) &&
       write(images, *image, {x, y, width, height}, format, type, pixels)))
    return;
  if (image->valid == Valid::Shadow)
    upload(images, *image);
  dropShadow(images, *image);
}

namespace {

/// True for byte formats that TexImage2D accepts with all formats of byteSource().
bool isPlainFormat(GLint internalFormat) {
  switch (internalFormat) {
  case 1:
  case 2:
  case 3:
  case 4:
  case GL_ALPHA:
  case GL_ALPHA8:
  case GL_LUMINANCE:
  case GL_LUMINANCE8:
  case GL_LUMINANCE_ALPHA:
  case GL_LUMINANCE8_ALPHA8:
  case GL_INTENSITY:
  case GL_INTENSITY8:
  case GL_RGB:
  case GL_RGB8:
  case GL_RGBA:
  case GL_RGBA8:
    return true;
  default:
    return false;
  }
}

} // namespace

void Residency::texImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
                           GLsizei height, GLint border, GLenum format, GLenum type,
                           const void *pixels) {
  ResidentImages &images = *m_images;
  if (!isAlone(images) || images.objects.textures.empty())
    return;
  Texture *const texture = bindingOf(target) == 0 ? nullptr : boundTexture(images, target);
  PixelImage *const image = texture ? knownLevelOf(*texture, target, level) : nullptr;
  ByteSource source;
  Definition now;
  if (image && border == 0 && isPlainFormat(internalFormat) && byteSource(format, type, source))
    now = {internalFormat, format, type, images.objects.descriptions};
  const bool isSame = now.at != 0 && image->definition == now &&
                      isDescribed(images.objects, *image) && width == image->width &&
                      height == image->height && image->depth == 1 && pixels &&
                      !makesMipmaps(images, target) && !isImmutable(images, *texture);
  if (isSame && (image->valid == Valid::Host ||
                 write(images, *image, {0, 0, width, height}, format, type, pixels)))
    return;
  textureRedefined(target);
  if (image)
    image->definition = now;
}

} // namespace arbiter::state
