// Frames, and contexts that become current and leave.
#include <cstring>
#include <utility>

#include "state/core/exit_notice.h"
#include "state/residency/residency_host.h"

namespace arbiter::state {

namespace {

/// Uploads an image of the window if it is pending.
void give(ResidentImages &images, PixelImage &image) {
  if (image.valid == Valid::Shadow)
    refreshWindowSize(images);
  if (image.valid != Valid::Shadow)
    return;
  upload(images, image);
  setValid(images, image, Valid::Both);
}

void updateBehind(ResidentImages &images) {
  bool behind = false;
  for (const PixelImage *image : images.objects.pending)
    behind = behind || image->valid == Valid::Shadow;
  for (const PixelImage *image : images.pending)
    behind = behind || image->valid == Valid::Shadow;
  images.hot.hostIsBehind = behind;
}

/// Copies the window's pixels to the application's memory, which it reads after Finish.
void copyToMemory(ResidentImages &images) {
  Drawable &drawable = images.drawable;
  PixelImage &image = images.color;
  if (image.valid != Valid::Shadow || image.shown || !drawable.memory)
    return;
  GLint rowLength = image.width;
  bool topRowFirst = false;
  if (drawable.memoryLayout)
    drawable.memoryLayout(drawable, rowLength, topRowFirst);
  const int bytes = drawable.memoryFormat == GL_RGB || drawable.memoryFormat == GL_BGR ? 3 : 4;
  writeApplicationRows(image.shadow, drawable.memoryFormat,
                       static_cast<std::uint8_t *>(drawable.memory),
                       std::ptrdiff_t(rowLength) * bytes, topRowFirst);
  image.shown = true;
}

/// True if only contexts that are current with the window can change its back buffer and depths.
/// That holds for windows of X. Others may write to other drawables of GLX and to EGL surfaces.
bool outlivesRelease(const ResidentImages &images) {
  return images.color.described != 0 && images.doubleBuffered && images.drawable.show &&
         images.drawable.kind == Drawable::Kind::Window &&
         !NeighbourEpoch::isCrowded(images.neighbours.epoch());
}

bool isSameWindow(const Drawable &a, const Drawable &b) {
  return isSameDrawable(a, b) && a.sameRead && b.sameRead && a.show == b.show &&
         a.presenter == b.presenter;
}

void dropWindow(ResidentImages &images) {
  dropShadow(images, images.color);
  dropShadow(images, images.depthStencil);
}

} // namespace

bool Residency::present() {
  ResidentImages &images = *m_images;
  dropIfNeighbourWasCurrent(images);
  // A pbuffer is not visible, and swapping it has no effect.
  if (images.drawable.kind != Drawable::Kind::Window)
    return false;
  PixelImage &color = images.color;
  const bool shown = images.doubleBuffered && images.drawable.show &&
                     color.valid == Valid::Shadow &&
                     images.drawable.show(images.drawable, color.shadow);
  if (shown) {
    color.shown = true;
  } else {
    give(images, color);
    updateBehind(images);
  }
  forgetSize(images);
  return shown;
}

void Residency::leave() {
  ResidentImages &images = *m_images;
  if (exitBegan()) // parts of the host may be gone, and nobody would see the upload
    return;
  images.draws.finish();
  images.released = false;
  if (images.hot.insideBeginEnd || images.hot.listMode != 0)
    return;
  // Between frames the host's buffers have the last frame's size. The host looks for a new one when
  // a frame begins, which this is not.
  if (images.color.described != 0 && hostMissedFrames(images))
    images.sizeKnown = true;
  synchronise("the context leaves its thread");
  // The host has written to its own copy of the application's memory.
  if (images.drawable.kind == Drawable::Kind::Memory && images.color.valid != Valid::Host)
    images.hot.host->Flush();
  images.released = outlivesRelease(images);
  if (!images.released)
    dropWindow(images);
}

void Residency::forgetWindow() {
  if (m_images->released)
    dropWindow(*m_images);
  m_images->released = false;
}

void Residency::enter(const Drawable &drawable) {
  ResidentImages &images = *m_images;
  // The next use queries the size, as after each frame.
  const bool kept =
      std::exchange(images.released, false) && isSameWindow(images.drawable, drawable);
  if (!kept) { // another context may have drawn to this window
    dropWindow(images);
    images.color.described = images.depthStencil.described = 0;
  }
  forgetSize(images);
  images.sizeSure = true;
  images.drawable = drawable;
  images.hot.dirty = ~0u;
  if (hostMissedFrames(images) && images.hot.executesNow())
    refreshWindowSize(images);
  updateBehind(images);
}

void Residency::flush(bool finish) {
  ResidentImages &images = *m_images;
  if (finish)
    images.draws.finish();
  else
    images.draws.post();
  const bool visible = images.drawable.kind == Drawable::Kind::Window && !images.doubleBuffered &&
                       images.color.valid == Valid::Shadow;
  if (visible || images.groupContexts.load(std::memory_order_relaxed) > 1 ||
      NeighbourEpoch::isCrowded(images.neighbours.epoch()))
    synchronise("flush");
  if (finish)
    images.hot.host->Finish();
  else
    images.hot.host->Flush();
  // A host that shows its front buffer behaves as after a swap.
  if (images.drawable.kind == Drawable::Kind::Window && !images.doubleBuffered)
    forgetSize(images);
  // After the host, which writes its own, older pixels there.
  if (images.drawable.kind == Drawable::Kind::Memory)
    copyToMemory(images);
}

} // namespace arbiter::state
