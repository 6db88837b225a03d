#include "state/residency/window_frames.h"

#include "util/cache/sealed.h"

namespace arbiter::state {

namespace {

constinit Sealed<WindowFrames> g_frames;

} // namespace

void setWindowFrames(const WindowFrames &frames) {
  g_frames.fill([&](WindowFrames &published) { published = frames; });
}

const WindowFrames &windowFrames() { return *g_frames; }

} // namespace arbiter::state
