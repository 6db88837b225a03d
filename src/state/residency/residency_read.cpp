// ReadPixels and GetTexImage from the shadow, for plain formats.
#include <cstring>

#include "state/residency/residency_host.h"

namespace arbiter::state {

namespace {

using abi::From;
using swrast::Image;
using swrast::Rect;

/// A pixel format of bytes: the component of RGBA that each byte holds.
struct ByteFormat {
  int bytes = 0;
  int component[4] = {};
};

bool byteFormat(GLenum format, GLenum type, ByteFormat &out) {
  const bool reversed = type == GL_UNSIGNED_INT_8_8_8_8_REV;
  if (type != GL_UNSIGNED_BYTE && !reversed)
    return false;
  switch (format) {
  case GL_RGBA:
    out = {4, {0, 1, 2, 3}};
    return true;
  case GL_BGRA:
    out = {4, {2, 1, 0, 3}};
    return true;
  case GL_RGB:
    out = {3, {0, 1, 2}};
    return !reversed;
  case GL_BGR:
    out = {3, {2, 1, 0}};
    return !reversed;
  case GL_RED:
  case GL_GREEN:
  case GL_BLUE:
  case GL_ALPHA:
    out = {1, {int(format - GL_RED)}};
    return !reversed;
  default:
    return false;
  }
}

void readRow(const std::uint8_t *from, int stored, const int (&source)[4], int bytes,
             std::uint8_t *to, int count) {
  for (int x = 0; x < count; ++x, from += stored, to += bytes)
    for (int i = 0; i < bytes; ++i)
      to[i] = source[i] >= 0 ? from[source[i]] : source[i] == -1 ? 0 : 0xFF;
}

/// Writes `rect` of an 8-bit image to rows of `stride` bytes. Returns false for other images.
bool writeRows(const Image &image, const Rect &rect, const ByteFormat &format, std::uint8_t *to,
               std::ptrdiff_t stride, bool topRowFirst) {
  const int stored = abi::bytesOf(image.format.layout);
  if (image.format.layout != abi::Layout::U8x1 && image.format.layout != abi::Layout::U8x2 &&
      image.format.layout != abi::Layout::U8x4)
    return false;
  int source[4] = {};
  bool straight = stored == format.bytes;
  for (int i = 0; i < format.bytes; ++i) {
    const From from = image.format.swizzle[std::size_t(format.component[i])];
    source[i] = from <= From::C3 ? int(from) : from == From::Zero ? -1 : -2;
    straight = straight && source[i] == i;
  }
  for (int y = 0; y < rect.height; ++y) {
    const std::uint8_t *const from = image.pixel(rect.x, rect.y + y);
    std::uint8_t *const row = to + (topRowFirst ? rect.height - 1 - y : y) * stride;
    if (straight)
      std::memcpy(row, from, std::size_t(rect.width) * std::size_t(stored));
    else
      readRow(from, stored, source, format.bytes, row, rect.width);
  }
  return true;
}

/// Writes `rect` of an 8-bit image as the application's pack state says.
bool readBytes(const Image &image, const Rect &rect, const ByteFormat &format,
               const PixelModes::Store &pack, std::uint8_t *to) {
  const std::int64_t rowPixels = pack.rowLength > 0 ? pack.rowLength : rect.width;
  const std::int64_t stride =
      (rowPixels * format.bytes + pack.alignment - 1) / pack.alignment * pack.alignment;
  to += pack.skipRows * stride + std::int64_t(pack.skipPixels) * format.bytes;
  return writeRows(image, rect, format, to, stride, pack.invert != 0);
}

bool plainStore(const PixelModes &modes) {
  return !modes.transfers && modes.pack.swapBytes == 0 && modes.pack.buffer == 0;
}

} // namespace

void writeApplicationRows(const Image &image, GLenum format, std::uint8_t *to,
                          std::ptrdiff_t stride, bool topRowFirst) {
  ByteFormat bytes;
  if (byteFormat(format, GL_UNSIGNED_BYTE, bytes))
    (void)writeRows(image, {0, 0, image.width, image.height}, bytes, to, stride, topRowFirst);
}

bool Residency::readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                           GLenum type, void *pixels) {
  ResidentImages &images = *m_images;
  ByteFormat bytes;
  if (!isAlone(images) || !pixels || width <= 0 || height <= 0 || !byteFormat(format, type, bytes))
    return false;
  ObjectImages &objects = images.objects;
  if (objects.shadowed.empty())
    return false;
  const PixelImage *const image = framebuffersOf(images).read;
  if (!image || image->valid == Valid::Host)
    return false;
  const PixelModes &modes = pixelModes(images);
  // The host leaves pixels outside the image unchanged, so it must execute such reads.
  if (!plainStore(modes) || x < 0 || y < 0 || width > image->width - x ||
      height > image->height - y)
    return false;
  return readBytes(image->shadow, {x, y, width, height}, bytes, modes.pack,
                   static_cast<std::uint8_t *>(pixels));
}

bool Residency::getTexImage(GLenum target, GLint level, GLenum format, GLenum type, void *pixels) {
  ResidentImages &images = *m_images;
  const GLenum binding = bindingOf(target);
  ByteFormat bytes;
  if (!isAlone(images) || !pixels || binding == 0 || !byteFormat(format, type, bytes))
    return false;
  ObjectImages &objects = images.objects;
  if (objects.shadowed.empty())
    return false;
  Texture *const texture = boundTexture(images, target);
  if (!texture)
    return false;
  const PixelImage *const image = levelOf(images, *texture, target, level);
  // GetTexImage returns luminance and intensity as red alone (6.1.4), unlike the shadow's swizzle,
  // which is for sampling.
  if (!image || image->valid == Valid::Host || image->depth != 1 ||
      (image->base != GL_RGBA && image->base != GL_RGB))
    return false;
  const PixelModes &modes = pixelModes(images);
  return plainStore(modes) && readBytes(image->shadow, {0, 0, image->width, image->height}, bytes,
                                        modes.pack, static_cast<std::uint8_t *>(pixels));
}

} // namespace arbiter::state
