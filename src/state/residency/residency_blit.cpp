// BlitFramebuffer in memory. Programs that draw to a texture show their frames with it (Wine's
// Direct3D).
#include <algorithm>
#include <cstdlib>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

using swrast::Image;
using swrast::Rect;

/// A blit that does not scale or convert. Destination pixel (x, y) is source pixel (x + dx, y +
/// dy), or (x + dx, dy - y) if flipped.
struct PlainBlit {
  Rect to;
  GLint dx = 0, dy = 0;
  bool flipped = false;
};

bool isPlain(const FramebufferBlit &blit, PlainBlit &plain) {
  constexpr std::int64_t kMax = 1 << 20; // keeps sums of coordinates from overflowing
  for (const GLint at : {blit.from.x0, blit.from.y0, blit.from.x1, blit.from.y1, blit.to.x0,
                         blit.to.y0, blit.to.x1, blit.to.y1})
    if (std::abs(std::int64_t(at)) > kMax)
      return false;
  const GLint width = blit.to.x1 - blit.to.x0, height = blit.to.y1 - blit.to.y0;
  const GLint fromHeight = blit.from.y1 - blit.from.y0;
  if (blit.mask != GL_COLOR_BUFFER_BIT || (blit.filter != GL_NEAREST && blit.filter != GL_LINEAR) ||
      width == 0 || height == 0 || blit.from.x1 - blit.from.x0 != width ||
      std::abs(fromHeight) != std::abs(height))
    return false;
  plain.to = {std::min(blit.to.x0, blit.to.x1), std::min(blit.to.y0, blit.to.y1), std::abs(width),
              std::abs(height)};
  plain.flipped = (fromHeight < 0) != (height < 0);
  plain.dx = std::min(blit.from.x0, blit.from.x1) - plain.to.x;
  const GLint bottom = std::min(blit.from.y0, blit.from.y1);
  plain.dy = plain.flipped ? bottom + plain.to.height - 1 + plain.to.y : bottom - plain.to.y;
  return true;
}

/// Returns the destination, clipped by the scissor and both images.
Rect visibleOf(const ResidentImages &images, const PlainBlit &plain, const Framebuffers &f,
               const PixelImage &from) {
  Rect area = swrast::intersect(plain.to, {0, 0, f.width, f.height});
  if (images.hot.host->IsEnabled(GL_SCISSOR_TEST)) {
    GLint box[4] = {};
    images.hot.host->GetIntegerv(GL_SCISSOR_BOX, box);
    area = swrast::intersect(area, {box[0], box[1], box[2], box[3]});
  }
  const GLint lowest = plain.flipped ? plain.dy - (from.height - 1) : -plain.dy;
  return swrast::intersect(area, {-plain.dx, lowest, from.width, from.height});
}

/// Returns the draw framebuffer's colour buffer if it has exactly one, else null.
PixelImage *onlyColor(const Framebuffers &f, int &slice) {
  PixelImage *only = nullptr;
  for (std::size_t i = 0; i < f.color.size(); ++i) {
    if (!f.color[i])
      continue;
    if (only)
      return nullptr;
    only = f.color[i];
    slice = f.slice[i];
  }
  return only;
}

/// True if the host would copy these values without converting or encoding them.
bool areAlike(const PixelImage &from, const PixelImage &to) {
  const abi::Format &source = from.shadow.format;
  const bool bytes = source.layout == abi::Layout::U8x4 && to.format.layout == abi::Layout::U8x4;
  return !from.srgb && !to.srgb && (bytes || source == to.format);
}

Image upsideDown(const Image &image) {
  Image result = image;
  result.offset += (image.height - 1) * image.rowStride;
  result.rowStride = -image.rowStride;
  return result;
}

} // namespace

bool Residency::blit(const FramebufferBlit &command) {
  ResidentImages &images = *m_images;
  PlainBlit plain;
  if (!isAlone(images) || images.objects.shadowed.empty() || !isPlain(command, plain))
    return false;
  const Framebuffers &f = framebuffersOf(images);
  PixelImage *const from = f.read;
  int slice = 0;
  PixelImage *const to = f.reason ? nullptr : onlyColor(f, slice);
  // If the source is host-valid, the host copies and no pixel needs to be moved.
  if (!from || !to || from == to || from->valid == Valid::Host || !areAlike(*from, *to))
    return false;
  const Rect area = visibleOf(images, plain, f, *from);
  const bool whole = to->depth == 1 && area == Rect{0, 0, to->width, to->height};
  if (area.empty() || (!whole && to->valid == Valid::Host))
    return false;
  from->shadow.complete();
  if (!makeOwn(images, *to, !whole))
    return false;
  const Image source = plain.flipped ? upsideDown(from->shadow) : from->shadow;
  const GLint bottom = plain.flipped ? from->height - 1 - (plain.dy - area.y) : area.y + plain.dy;
  Image target = to->shadow;
  target.offset += slice * target.sliceStride;
  swrast::copyPixels(target, area.x, area.y, 0, source,
                     {area.x + plain.dx, bottom, area.width, area.height});
  setValid(images, *to, Valid::Shadow);
  images.objects.drawn = true;
  to->drawnHere = true;
  return true;
}

} // namespace arbiter::state
