// Decides when pixels must be moved: synchronisation, frames, contexts.
#include "state/residency/residency.h"

#include <algorithm>
#include <cstring>

#include "state/residency/residency_host.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

void uploadList(ResidentImages &images, std::vector<PixelImage *> &list) {
  // An upload that finds no memory stays in the list, as its shadow is the only valid copy.
  while (!list.empty()) {
    PixelImage *const image = list.back();
    if (image->valid == Valid::Shadow) {
      upload(images, *image);
      setValid(images, *image, Valid::Both);
    }
    image->listed = false;
    list.pop_back();
  }
}

void uploadAll(ResidentImages &images) {
  if (!images.pending.empty())
    refreshWindowSize(images);
  uploadList(images, images.objects.pending);
  uploadList(images, images.pending);
  images.hot.hostIsBehind = false;
}

void dropObjects(ResidentImages &images) {
  // Backwards, as removing an entry moves the last one into its place.
  const std::vector<PixelImage *> &shadowed = images.objects.shadowed;
  for (std::size_t i = shadowed.size(); i-- > 0;)
    if (shadowed[i]->place.kind != Place::Kind::Window)
      dropShadow(images, *shadowed[i]);
}

void dropFramebuffer(ResidentImages &images) {
  const Framebuffers &f = framebuffersOf(images);
  const auto drop = [&](PixelImage *image) {
    if (image)
      dropShadow(images, *image);
  };
  for (PixelImage *image : f.color)
    drop(image);
  drop(f.depthStencil);
  // If the rasterizer cannot draw to the framebuffer, not all of its attachments are known, so any
  // image may be one of them.
  if (f.drawName != 0 && f.reason)
    dropObjects(images);
  if (f.drawName == 0) {
    // A host that draws to both buffers makes no difference between front and back.
    drop(&images.color);
    drop(&images.depthStencil);
  }
}

void dropAll(ResidentImages &images) {
  ObjectImages &objects = images.objects;
  dropObjects(images);
  dropShadow(images, images.color);
  dropShadow(images, images.depthStencil);
  ++objects.descriptions;
  objects.redefined();
  images.hot.dirty = ~0u;
}

/// Forgets all objects. None of them may be pending.
void forgetObjects(ResidentImages &images) {
  ObjectImages &objects = images.objects;
  objects.textures.clear();
  objects.renderbuffers.clear();
  objects.pending.clear();
  objects.way = {};
  images.framebuffers = {};
}

} // namespace

void dropIfNeighbourWasCurrent(ResidentImages &images) {
  const std::uint64_t epoch = images.neighbours.epoch();
  if (images.epoch == epoch) [[likely]]
    return;
  images.objects.way = {}; // the upload texture may hold the neighbour's pixels
  uploadAll(images);
  dropAll(images);
  forgetObjects(images);
  images.epoch = NeighbourEpoch::isCrowded(epoch) ? 0 : epoch;
}

bool isAlone(ResidentImages &images) {
  dropIfNeighbourWasCurrent(images);
  return images.epoch != 0;
}

Residency::Residency(const Surroundings &around) : m_images(new ResidentImages(around)) {}
Residency::~Residency() = default;

bool Residency::syncWithNeighbours() { return isAlone(*m_images); }

void Residency::forget() {
  ResidentImages &images = *m_images;
  if (images.hot.hostIsBehind)
    return; // the context left in the middle of a list or a primitive
  dropAll(images);
  forgetObjects(images);
}

void Residency::synchronise(const char *why) {
  ResidentImages &images = *m_images;
  if (!images.hot.hostIsBehind)
    return;
  dropIfNeighbourWasCurrent(images);
  logDebug("residency", "the host is brought up to date: %s", why);
  uploadAll(images);
}

void Residency::hostTakesTargets(const char *why) {
  ResidentImages &images = *m_images;
  synchronise(why);
  dropIfNeighbourWasCurrent(images);
  if (hostMissedFrames(images))
    refreshWindowSize(images);
  if (!images.objects.shadowed.empty())
    dropFramebuffer(images);
}

void Residency::hostDoesAnything(const char *why) {
  synchronise(why);
  dropAll(*m_images);
}

void Residency::drawableMayHaveChanged(const swrast::Rect &viewport) {
  ResidentImages &images = *m_images;
  auto &recent = images.viewports;
  const auto known = std::find(recent.begin(), recent.end(), viewport);
  if (known != recent.end())
    return;
  images.sizeSure = true;
  std::rotate(recent.begin(), recent.end() - 1, recent.end());
  recent.front() = viewport;
}

void forgetSize(ResidentImages &images) {
  images.sizeKnown = false;
  images.objects.changed();
}

std::uint64_t Residency::version() const { return m_images->objects.version; }

const ResidencyStatistics &Residency::statistics() const { return m_images->objects.statistics; }

} // namespace arbiter::state
