// Frames, and contexts that come and go.
#include <cstring>

#include "state/share_group.h"
#include "state/software/residency_host.h"

namespace arbiter::state::software {

namespace {

/// One image of the window given to the host, if it is newer.
void give(Context &context, WindowImages &window, PixelImage &image) {
  if (image.newest == Newest::Shadow)
    lookAtWindow(context, window);
  if (image.newest != Newest::Shadow)
    return;
  upload(context, window, image);
  setNewest(context, image, Newest::Both);
}

void updateBehind(Context &context, const WindowImages &window) {
  bool behind = false;
  for (const PixelImage *image : objectsOf(context).pending)
    behind = behind || image->newest == Newest::Shadow;
  for (const PixelImage *image : window.pending)
    behind = behind || image->newest == Newest::Shadow;
  context.hostIsBehind = behind;
}

/// The window's pixels to the application's memory, which it reads after Finish.
void copyToMemory(WindowImages &window) {
  Drawable &drawable = window.drawable;
  PixelImage &image = window.color;
  if (image.newest != Newest::Shadow || image.shown || !drawable.memory)
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

} // namespace

bool present(Context &context) {
  WindowImages *const window = settledWindowOf(context);
  if (!window)
    return false;
  // Nobody sees a pbuffer, and swapping it does nothing to it.
  if (window->drawable.kind != Drawable::Kind::Window)
    return false;
  PixelImage &color = window->color;
  const bool shown = window->doubleBuffered && window->drawable.show &&
                     color.newest == Newest::Shadow &&
                     window->drawable.show(window->drawable, color.shadow);
  if (shown) {
    color.shown = true;
  } else {
    give(context, *window, color);
    updateBehind(context, *window);
  }
  forgetSize(context, *window);
  return shown;
}

void leave(Context &context) {
  if (!context.software || !context.software->images || context.insideBeginEnd ||
      context.listMode != 0)
    return;
  synchronise(context, "the context leaves its thread");
  WindowImages &window = *windowOf(context);
  // The host wrote to its own copy of the application's memory.
  if (window.drawable.kind == Drawable::Kind::Memory && window.color.newest != Newest::Host)
    context.host->Flush();
  dropShadow(context, window.color);
  dropShadow(context, window.depthStencil);
}

void enter(Context &context) {
  WindowImages *const window = windowOf(context);
  if (!window)
    return;
  // Another context may have drawn to this window.
  dropShadow(context, window->color);
  dropShadow(context, window->depthStencil);
  window->color.described = window->depthStencil.described = false;
  forgetSize(context, *window);
  window->sizeSure = true;
  window->drawable = context.drawable;
  context.stale = ~0u;
  if (hostMissedFrames(*window) && !context.insideBeginEnd && context.listMode == 0)
    lookAtWindow(context, *window);
  updateBehind(context, *window);
}

void flush(Context &context, bool finish) {
  WindowImages *const window = windowOf(context);
  if (window) {
    const bool visible = window->drawable.kind == Drawable::Kind::Window &&
                         !window->doubleBuffered && window->color.newest == Newest::Shadow;
    if (visible || sharesObjects(context) || Neighbours::isCrowded(context.neighbours.epoch()))
      synchronise(context, "flush");
  }
  if (finish)
    context.host->Finish();
  else
    context.host->Flush();
  // A host that shows its front buffer swaps, in a way.
  if (window && window->drawable.kind == Drawable::Kind::Window && !window->doubleBuffered)
    forgetSize(context, *window);
  // After the host, which writes its own, older pixels there.
  if (window && window->drawable.kind == Drawable::Kind::Memory)
    copyToMemory(*window);
}

} // namespace arbiter::state::software
