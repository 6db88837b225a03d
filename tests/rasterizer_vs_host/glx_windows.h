#pragma once
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// Windows of an X display that GLX draws to, for clients that have several or change them.
namespace software {

/// The first configuration of RGBA8, 24 bits of depth and 8 of stencil, double buffered, for all of
/// `drawables` (GLX_WINDOW_BIT, ..); null where there is none.
[[nodiscard]] GLXFBConfig chooseGlxConfig(Display *display, int drawables);

struct WindowOptions {
  int x = 0, y = 0;     ///< of its upper left corner, on the screen
  bool mapped = true;   ///< shown at once
  bool cleared = false; ///< the server fills with black what nothing was drawn to
};
[[nodiscard]] Window makeWindow(Display *display, GLXFBConfig config, int width, int height,
                                const WindowOptions &options = {});

/// What the window shows now, RGBA8 with an alpha of 255, bottom row first; empty where the server
/// has no pixels of it. Makes no request before it: what GL has not sent yet is not waited for.
[[nodiscard]] std::vector<unsigned char> grabWindow(Display *display, Window window, int width,
                                                    int height);

} // namespace software
