// When pixels must be moved: synchronisation, frames, contexts.
#include "state/software/residency.h"

#include <algorithm>
#include <cstring>

#include "state/share_group.h"
#include "state/software/residency_host.h"
#include "util/log.h"

namespace arbiter::state::software {

namespace {

void uploadList(Context &context, WindowImages &window, std::vector<PixelImage *> &list) {
  // One by one: what finds no memory stays in the list, as its shadow is what counts.
  while (!list.empty()) {
    PixelImage *const image = list.back();
    if (image->newest == Newest::Shadow) {
      upload(context, window, *image);
      setNewest(context, *image, Newest::Both);
    }
    image->listed = false;
    list.pop_back();
  }
}

void uploadAll(Context &context, WindowImages &window) {
  if (!window.pending.empty())
    lookAtWindow(context, window);
  uploadList(context, window, objectsOf(context).pending);
  uploadList(context, window, window.pending);
  context.hostIsBehind = false;
}

void dropObjects(Context &context) {
  ObjectImages &objects = objectsOf(context);
  objects.absent.fill(-1);
  for (const auto &[name, texture] : objects.textures)
    for (const std::unique_ptr<PixelImage> &image : texture->images)
      if (image)
        dropShadow(context, *image);
  for (const auto &[name, image] : objects.renderbuffers)
    dropShadow(context, *image);
}

void dropFramebuffer(Context &context, WindowImages &window) {
  const Framebuffers &f = framebuffersOf(context, window);
  const auto drop = [&](PixelImage *image) {
    if (image)
      dropShadow(context, *image);
  };
  for (PixelImage *image : f.color)
    drop(image);
  drop(f.depthStencil);
  // What is attached to a framebuffer that is not ours is not all known: any image may be.
  if (f.drawName != 0 && f.reason)
    dropObjects(context);
  if (f.drawName == 0) {
    // The front and the back buffer are not told apart where the host draws to both.
    drop(&window.color);
    drop(&window.depthStencil);
  }
}

void dropAll(Context &context, WindowImages &window) {
  ObjectImages &objects = objectsOf(context);
  for (const auto &[name, texture] : objects.textures)
    for (const std::unique_ptr<PixelImage> &image : texture->images)
      if (image) {
        dropShadow(context, *image);
        image->described = false;
      }
  for (const auto &[name, image] : objects.renderbuffers) {
    dropShadow(context, *image);
    image->described = false;
  }
  dropShadow(context, window.color);
  dropShadow(context, window.depthStencil);
  objects.redefined();
  context.stale = ~0u;
}

/// Nothing is known of any object; nothing is pending.
void forget(WindowImages &window) {
  ObjectImages &objects = window.objects;
  objects.textures.clear();
  objects.renderbuffers.clear();
  objects.pending.clear();
  objects.way = {};
  objects.absent.fill(-1);
  window.framebuffers = {};
}

} // namespace

WindowImages *settledWindowOf(Context &context) {
  WindowImages *const window = windowOf(context);
  if (!window)
    return nullptr;
  const std::uint64_t epoch = context.neighbours.epoch();
  if (window->epoch == epoch) [[likely]]
    return window;
  uploadAll(context, *window);
  dropAll(context, *window);
  forget(*window);
  window->epoch = Neighbours::isCrowded(epoch) ? 0 : epoch;
  return window;
}

WindowImages *undisturbedWindowOf(Context &context) {
  WindowImages *const window = settledWindowOf(context);
  return window && window->epoch != 0 ? window : nullptr;
}

bool settle(Context &context) { return undisturbedWindowOf(context) != nullptr; }

void forgetImages(Context &context) {
  WindowImages *const window =
      context.software ? static_cast<WindowImages *>(context.software->images.get()) : nullptr;
  if (!window || context.hostIsBehind)
    return; // it left in the middle of a list or a primitive
  dropAll(context, *window);
  forget(*window);
}

void synchronise(Context &context, const char *why) {
  if (!context.hostIsBehind)
    return;
  WindowImages *const window = settledWindowOf(context);
  if (!window)
    return;
  logDebug("residency", "the host is brought up to date: %s", why);
  uploadAll(context, *window);
}

void hostDraws(Context &context, const char *why) {
  if (context.software)
    ++context.software->hostTurns;
  hostTakesTargets(context, why);
}

void hostTakesTargets(Context &context, const char *why) {
  synchronise(context, why);
  WindowImages *const window = settledWindowOf(context);
  if (window && hostMissedFrames(*window))
    lookAtWindow(context, *window);
  if (window && window->objects.valid != 0)
    dropFramebuffer(context, *window);
}

void hostDrawsList(Context &context) {
  if (context.software)
    ++context.software->hostTurns;
  hostDoesAnything(context, "glCallList");
}

void hostDoesAnything(Context &context, const char *why) {
  synchronise(context, why);
  WindowImages *const window = windowOf(context);
  if (!window)
    return;
  dropAll(context, *window);
}

void drawableMayHaveChanged(Context &context, const swrast::Rect &viewport) {
  if (!context.software || !context.software->images)
    return;
  WindowImages &window = *windowOf(context);
  auto &recent = window.viewports;
  const auto known = std::find(recent.begin(), recent.end(), viewport);
  if (known != recent.end())
    return;
  window.sizeSure = true;
  std::rotate(recent.begin(), recent.end() - 1, recent.end());
  recent.front() = viewport;
}

void forgetSize(Context &context, WindowImages &window) {
  window.sizeKnown = false;
  objectsOf(context).changed();
}

std::uint64_t imagesVersion(const Context &context) {
  const auto *const window = static_cast<const WindowImages *>(context.software->images.get());
  return window ? window->objects.version : 0;
}

ResidencyStatistics residencyStatistics(const Context &context) {
  ResidencyStatistics statistics;
  if (context.software && context.software->images)
    statistics = static_cast<const WindowImages &>(*context.software->images).objects.statistics;
  statistics.shadowBytes = swrast::Storage::totalBytes();
  return statistics;
}

} // namespace arbiter::state::software
