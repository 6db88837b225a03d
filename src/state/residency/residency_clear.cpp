// Clear in memory.
#include <algorithm>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

using swrast::Rect;

/// The effect of Clear on each buffer, from the host's state.
struct ClearState {
  Rect area; ///< the scissor rectangle
  float color[4] = {};
  unsigned colorMask = 0xF;
  bool depthMask = true;
  double depth = 1;
  std::uint8_t stencilMask = 0xFF, stencil = 0;
};

ClearState clearState(const ResidentImages &images, const Framebuffers &f, GLbitfield mask) {
  const host::HostTable &host = *images.hot.host;
  ClearState state;
  state.area = {0, 0, f.width, f.height};
  if (host.IsEnabled(GL_SCISSOR_TEST)) {
    GLint box[4] = {};
    host.GetIntegerv(GL_SCISSOR_BOX, box);
    state.area = swrast::intersect(state.area, {box[0], box[1], box[2], box[3]});
  }
  if ((mask & GL_COLOR_BUFFER_BIT) != 0) {
    host.GetFloatv(GL_COLOR_CLEAR_VALUE, state.color);
    GLboolean write[4] = {};
    host.GetBooleanv(GL_COLOR_WRITEMASK, write);
    state.colorMask = 0;
    for (unsigned i = 0; i < 4; ++i)
      state.colorMask |= write[i] ? 1u << i : 0u;
  }
  if ((mask & GL_DEPTH_BUFFER_BIT) != 0) {
    GLboolean write = GL_TRUE;
    host.GetBooleanv(GL_DEPTH_WRITEMASK, &write);
    state.depthMask = write != GL_FALSE;
    host.GetDoublev(GL_DEPTH_CLEAR_VALUE, &state.depth);
  }
  if ((mask & GL_STENCIL_BUFFER_BIT) != 0) {
    GLint write = 0, value = 0;
    host.GetIntegerv(GL_STENCIL_WRITEMASK, &write);
    host.GetIntegerv(GL_STENCIL_CLEAR_VALUE, &value);
    state.stencilMask = std::uint8_t(write);
    state.stencil = std::uint8_t(value);
  }
  return state;
}

bool covers(const Rect &rect, const PixelImage &image) {
  return image.depth == 1 && rect.x == 0 && rect.y == 0 && rect.width >= image.width &&
         rect.height >= image.height;
}

/// True if the image is cleared in memory: its shadow is valid, or all of it is cleared and the
/// rasterizer was the last to write to it.
bool clearsInMemory(const PixelImage &image, bool whole) {
  return image.valid != Valid::Host || (whole && image.drawnHere);
}

bool clearColor(ResidentImages &images, PixelImage &image, int slice, const ClearState &state) {
  const bool whole = covers(state.area, image) && state.colorMask == 0xF;
  if (!makeOwn(images, image, !whole))
    return false;
  swrast::Image part = image.shadow;
  part.offset += slice * part.sliceStride;
  swrast::fill(part, state.area, state.color, state.colorMask);
  setValid(images, image, Valid::Shadow);
  return true;
}

/// True if Clear encodes colours as sRGB. The host clears then.
bool encodes(const ResidentImages &images, const Framebuffers &f) {
  return std::any_of(f.color.begin(), f.color.end(),
                     [](const PixelImage *image) { return image && image->srgb; }) &&
         images.caps.srgbFramebuffer && images.hot.host->IsEnabled(GL_FRAMEBUFFER_SRGB);
}

/// Returns the parts of `mask` that were cleared in memory.
GLbitfield clearOurs(ResidentImages &images, GLbitfield mask) {
  const Framebuffers &f = framebuffersOf(images);
  if (f.reason)
    return 0;
  const ClearState state = clearState(images, f, mask);
  GLbitfield done = 0;
  if ((mask & GL_COLOR_BUFFER_BIT) != 0) {
    const bool all = state.colorMask == 0xF;
    bool possible = !encodes(images, f);
    for (const PixelImage *image : f.color)
      possible = possible && (!image || clearsInMemory(*image, all && covers(state.area, *image)));
    bool failed = false;
    if (possible && !state.area.empty())
      for (std::size_t i = 0; i < f.color.size(); ++i)
        failed = failed || (f.color[i] && !clearColor(images, *f.color[i], f.slice[i], state));
    if (possible && !failed)
      done |= GL_COLOR_BUFFER_BIT;
  }
  const GLbitfield rest = mask & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  if (rest == 0)
    return done;
  if (!f.depthStencil)
    return done | rest; // there is nothing to clear
  PixelImage &image = *f.depthStencil;
  const bool depth = (rest & GL_DEPTH_BUFFER_BIT) != 0 && state.depthMask;
  const std::uint8_t stencil = (rest & GL_STENCIL_BUFFER_BIT) != 0 ? state.stencilMask : 0;
  const bool whole = covers(state.area, image) && depth && (stencil == 0xFF || f.stencilBits == 0);
  if (!clearsInMemory(image, whole) || !makeOwn(images, image, !whole))
    return done;
  if (!state.area.empty())
    swrast::fillDepthStencil(image.shadow, state.area, depth, state.depth, stencil, state.stencil);
  setValid(images, image, Valid::Shadow);
  return done | rest;
}

} // namespace

const void *Residency::wholeTargetCleared(GLbitfield mask) {
  ResidentImages &images = *m_images;
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if (!isAlone(images) || (mask & kBoth) != kBoth)
    return nullptr;
  const Framebuffers &f = framebuffersOf(images);
  if (f.reason || !f.depthStencil)
    return nullptr;
  const ClearState state = clearState(images, f, mask);
  const bool whole =
      state.colorMask == 0xF && state.depthMask && covers(state.area, *f.depthStencil);
  return whole ? f.depthStencil : nullptr;
}

bool Residency::clear(GLbitfield mask) {
  ResidentImages &images = *m_images;
  constexpr GLbitfield kOurs = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  if (!isAlone(images) || mask == 0 || (mask & ~kOurs) != 0)
    return false;
  ObjectImages &objects = images.objects;
  // This keeps Clear free for applications that the rasterizer never draws for.
  if (objects.shadowed.empty() && !objects.drawn)
    return false;
  const GLbitfield done = clearOurs(images, mask);
  if (done == mask)
    return true;
  const Framebuffers &f = framebuffersOf(images);
  if (f.reason || (done == 0 && (mask & GL_COLOR_BUFFER_BIT) != 0))
    return false;
  // The host clears the rest, for which its copy must be valid. Depths that the rasterizer does not
  // use move no colours, even if a command of their own clears them.
  const GLbitfield rest = mask & ~done;
  if ((rest & GL_COLOR_BUFFER_BIT) != 0)
    for (PixelImage *image : f.color)
      if (image) {
        if (image->valid == Valid::Shadow)
          upload(images, *image);
        dropShadow(images, *image);
      }
  if ((rest & ~GLbitfield(GL_COLOR_BUFFER_BIT)) != 0 && f.depthStencil) {
    if (f.depthStencil->valid == Valid::Shadow)
      upload(images, *f.depthStencil);
    dropShadow(images, *f.depthStencil);
  }
  images.hot.host->Clear(rest);
  return true;
}

} // namespace arbiter::state
