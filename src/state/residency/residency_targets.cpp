// The draw framebuffer as images to draw to.
#include <algorithm>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

bool covers(const swrast::Rect &rect, const PixelImage &image) {
  return image.depth == 1 && rect.x <= 0 && rect.y <= 0 && rect.x + rect.width >= image.width &&
         rect.y + rect.height >= image.height;
}

/// Restores the image's own format, if a copy left another one that gives the same values.
bool restoreFormat(ResidentImages &images, PixelImage &image) {
  if (image.shadow.empty() || writable(image.shadow.format, image.format))
    return true;
  swrast::Image own = swrast::makeImage(image.format, image.width, image.height, image.depth);
  if (own.empty())
    return false;
  for (int z = 0; z < image.depth; ++z)
    swrast::copyPixels(own, 0, 0, z, image.shadow, {0, 0, image.width, image.height}, z);
  image.shadow = std::move(own);
  images.objects.changed();
  return true;
}

/// Makes the shadow the valid copy, ready to be written to.
bool acquire(ResidentImages &images, PixelImage &image, bool keep) {
  if (keep && image.valid == Valid::Host && !download(images, image))
    return false;
  if (!makeOwn(images, image, keep))
    return false;
  setValid(images, image, Valid::Shadow);
  images.objects.drawn = true;
  image.drawnHere = true;
  return true;
}

/// Returns the description of the draw framebuffer.
const DrawTargets &tell(ResidentImages &images) {
  const Framebuffers &f = images.framebuffers;
  DrawTargets &targets = images.targets;
  targets = {};
  targets.width = f.width;
  targets.height = f.height;
  for (std::size_t i = 0; i < f.color.size(); ++i) {
    if (!f.color[i])
      continue;
    targets.color[i] = &f.color[i]->shadow;
    targets.slice[i] = f.slice[i];
  }
  targets.depthStencil = f.depthStencil ? &f.depthStencil->shadow : nullptr;
  targets.depthBits = f.depthBits;
  targets.stencilBits = f.stencilBits;
  targets.isWindow = f.drawName == 0;
  targets.doubleBuffered = targets.isWindow && images.doubleBuffered;
  return targets;
}

} // namespace

const DrawTargets *Residency::describeTargets(const char *&reason) {
  ResidentImages &images = *m_images;
  dropIfNeighbourWasCurrent(images);
  reason = "target";
  const Framebuffers &f = framebuffersOf(images);
  if (f.reason) {
    reason = f.reason;
    return nullptr;
  }
  for (PixelImage *image : f.color)
    if (image && !restoreFormat(images, *image)) {
      reason = "memory";
      return nullptr;
    }
  return &tell(images);
}

const DrawTargets *Residency::targetsBefore() {
  ResidentImages &images = *m_images;
  const Framebuffers &f = images.framebuffers;
  const bool same = (images.hot.dirty & dirty::kFramebuffer) == 0 &&
                    f.generation == images.objects.generation && !f.reason;
  return same && f.drawName == 0 ? &tell(images) : nullptr;
}

bool Residency::targetsHeld(bool depthStencilUsed) {
  ResidentImages &images = *m_images;
  const Framebuffers &f = images.framebuffers;
  const auto isHeld = [](const PixelImage *image) {
    return !image || (image->valid == Valid::Shadow && image->listed && !image->shadow.shared() &&
                      !image->shadow.storage->isRead());
  };
  if (!std::all_of(f.color.begin(), f.color.end(), isHeld) ||
      (depthStencilUsed && !isHeld(f.depthStencil)))
    return false;
  for (PixelImage *image : f.color)
    if (image)
      image->shown = false;
  images.hot.hostIsBehind = true;
  return true;
}

bool Residency::acquireTargets(const swrast::Rect &overwritten, bool depthUsed, bool stencilUsed) {
  ResidentImages &images = *m_images;
  const Framebuffers &f = framebuffersOf(images);
  if (f.reason)
    return false;
  for (PixelImage *image : f.color)
    if (image && !acquire(images, *image, !covers(overwritten, *image)))
      return false;
  return !f.depthStencil || !(depthUsed || stencilUsed) || acquire(images, *f.depthStencil, true);
}

} // namespace arbiter::state
