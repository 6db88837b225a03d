// Feedback: copies from the read buffer to a level of a texture.
#include <algorithm>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

using swrast::Image;
using swrast::Rect;

/// Returns a part of an image, sharing its memory.
Image partOf(const Image &image, const Rect &rect) {
  Image part = image;
  part.width = rect.width;
  part.height = rect.height;
  part.depth = 1;
  part.offset +=
      rect.y * image.rowStride + std::ptrdiff_t(rect.x) * abi::bytesOf(image.format.layout);
  return part;
}

/// True if a part should share memory. A small part would keep a large storage alive.
bool worthSharing(const Image &image, const Rect &rect) {
  return 2 * std::int64_t(rect.width) * rect.height >= std::int64_t(image.width) * image.height;
}

/// Returns the level that the copy writes to. Null if the host must decide: for errors, or if the
/// copy would redefine the level.
PixelImage *destination(ResidentImages &images, const CopyToTexture &copy) {
  if (bindingOf(copy.target) == 0 || !isNamedAsBound(images, copy.texture) ||
      makesMipmaps(images, copy.target))
    return nullptr;
  Texture &texture = textureOf(images.objects, textureTargetOf(copy.target), copy.texture);
  PixelImage *const image = levelOf(images, texture, copy.target, copy.level);
  if (!image || image->base == 0)
    return nullptr;
  const Rect to = {copy.destX, copy.destY, copy.width, copy.height};
  if (copy.defines) {
    const bool same = !isImmutable(images, texture) && copy.border == 0 &&
                      GLint(copy.internalFormat) == image->internalFormat &&
                      copy.width == image->width && copy.height == image->height &&
                      image->depth == 1;
    return same ? image : nullptr;
  }
  const bool inside = to.x >= 0 && to.y >= 0 && to.width > 0 && to.height > 0 &&
                      to.width <= image->width - to.x && to.height <= image->height - to.y &&
                      copy.destZ >= 0 && copy.destZ < image->depth;
  return inside ? image : nullptr;
}

bool copyInMemory(ResidentImages &images, PixelImage &to, const PixelImage &from,
                  const CopyToTexture &copy, const Rect &source, bool whole) {
  if (!whole && to.valid == Valid::Host && !download(images, to))
    return false;
  // keeps the pixels if `to` is the image that is read
  const Image pixels = from.shadow;
  if (!whole && !to.shadow.empty() && to.shadow.format.layout != to.format.layout)
    return false;
  if (!makeOwn(images, to, !whole))
    return false;
  swrast::copyPixels(to.shadow, copy.destX + source.x - copy.x, copy.destY + source.y - copy.y,
                     copy.destZ, pixels, source);
  return true;
}

bool hasShadow(const PixelImage *image) { return image && image->valid != Valid::Host; }

/// Finds a view of `from` in the texture's format. Returns false if pixels must be converted.
bool viewFor(const PixelImage &from, const PixelImage &to, abi::Format &view) {
  if (to.base != GL_DEPTH_COMPONENT)
    return viewAs(from.shadow.format, to.base, to.format, view);
  view = to.format;
  return from.shadow.format == to.format && from.depth == 1;
}

bool copyBetweenShadows(ResidentImages &images, const CopyToTexture &copy) {
  const Framebuffers &f = framebuffersOf(images);
  // If the source is host-valid, the host copies and no pixel needs to be moved.
  if (!hasShadow(f.read) && !hasShadow(f.readDepth))
    return false;
  PixelImage *const to = destination(images, copy);
  if (!to)
    return false;
  const bool depths = to->base == GL_DEPTH_COMPONENT;
  PixelImage *const from = depths ? f.readDepth : f.read;
  const PixelModes &modes = pixelModes(images);
  if (!hasShadow(from) || (depths ? modes.transfersDepth : modes.transfers))
    return false;
  abi::Format view;
  if (!viewFor(*from, *to, view))
    return false;
  const Rect source = swrast::intersect({copy.x, copy.y, copy.width, copy.height},
                                        {0, 0, from->width, from->height});
  if (source.empty())
    return false;
  const bool whole = source.width == to->width && source.height == to->height && to->depth == 1;
  ObjectImages &objects = images.objects;
  if (whole && from != to && worthSharing(from->shadow, source)) {
    to->shadow = partOf(from->shadow, source);
    to->shadow.format = view;
    objects.changed();
    ++objects.statistics.copiesShared;
  } else {
    if (!copyInMemory(images, *to, *from, copy, source, whole))
      return false;
    ++objects.statistics.copiesInMemory;
  }
  setValid(images, *to, Valid::Shadow);
  return true;
}

} // namespace

bool Residency::copyToTexture(const CopyToTexture &copy) {
  ResidentImages &images = *m_images;
  if (isAlone(images) && !images.objects.shadowed.empty() && copyBetweenShadows(images, copy))
    return true;
  // The host copies from its read buffer, and the texture is its own afterwards.
  synchronise("glCopyTexImage");
  textureRedefined(textureTargetOf(copy.target));
  return false;
}

} // namespace arbiter::state
