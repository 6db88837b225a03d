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
  for (PixelImage *const image : list) {
    image->listed = false;
    if (image->newest != Newest::Shadow)
      continue;
    upload(context, window, *image);
    setNewest(context, *image, Newest::Both);
  }
  list.clear();
}

void uploadAll(Context &context, WindowImages &window) {
  uploadList(context, window, sharedOf(context).pending);
  uploadList(context, window, window.pending);
  context.hostIsBehind = false;
}

/// Under the lock; false where there is nothing of ours.
bool hasImages(Context &context) { return windowOf(context) && sharedOf(context).valid != 0; }

void dropObjects(Context &context) {
  SharedImages &shared = sharedOf(context);
  shared.absent.fill(-1);
  for (const auto &[name, texture] : shared.textures)
    for (const std::unique_ptr<PixelImage> &image : texture->images)
      if (image)
        dropShadow(context, *image);
  for (const auto &[name, image] : shared.renderbuffers)
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
  SharedImages &shared = sharedOf(context);
  for (const auto &[name, texture] : shared.textures)
    for (const std::unique_ptr<PixelImage> &image : texture->images)
      if (image) {
        dropShadow(context, *image);
        image->described = false;
      }
  for (const auto &[name, image] : shared.renderbuffers) {
    dropShadow(context, *image);
    image->described = false;
  }
  dropShadow(context, window.color);
  dropShadow(context, window.depthStencil);
  shared.redefined();
  context.stale = ~0u;
}

} // namespace

void settle(Context &context, WindowImages &window) {
  SharedImages &shared = sharedOf(context);
  if (window.turn == shared.turn) [[likely]]
    return;
  uploadAll(context, window);
  dropAll(context, window);
  window.turn = shared.turn;
}

void settle(Context &context) {
  if (WindowImages *const window = windowOf(context)) {
    const std::lock_guard lock(sharedOf(context).mutex);
    settle(context, *window);
  }
}

void synchronise(Context &context, const char *why) {
  if (!context.hostIsBehind)
    return;
  WindowImages *const window = windowOf(context);
  if (!window)
    return;
  logDebug("residency", "the host is brought up to date: %s", why);
  const std::lock_guard lock(sharedOf(context).mutex);
  uploadAll(context, *window);
}

void hostDraws(Context &context, const char *why) {
  if (context.software)
    ++context.software->hostTurns;
  hostTakesTargets(context, why);
}

void hostTakesTargets(Context &context, const char *why) {
  synchronise(context, why);
  SharedImages *const shared = context.software ? &sharedOf(context) : nullptr;
  if (!shared)
    return;
  const std::lock_guard lock(shared->mutex);
  if (hasImages(context))
    dropFramebuffer(context, *windowOf(context));
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
  const std::lock_guard lock(sharedOf(context).mutex);
  dropAll(context, *window);
}

void setDrawable(Context &context, const Drawable &drawable) {
  // Kept with the context, whose rasterizer may be engaged later.
  context.drawable = drawable;
}

void drawableMayHaveChanged(Context &context, const swrast::Rect &viewport) {
  if (!context.software || !context.software->images)
    return;
  WindowImages &window = *windowOf(context);
  forgetSize(context, window);
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
  sharedOf(context).changed();
}

std::uint64_t imagesVersion(const Context &context) {
  return context.group->softwareImages().version.load(std::memory_order_relaxed);
}

bool aloneInGroup(const Context &context) {
  return context.group->softwareImages().current.load(std::memory_order_relaxed) <= 1;
}

ResidencyStatistics residencyStatistics(const Context &context) {
  ResidencyStatistics statistics = context.group->softwareImages().statistics;
  statistics.shadowBytes = swrast::Storage::totalBytes();
  return statistics;
}

} // namespace arbiter::state::software
