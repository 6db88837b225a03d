#pragma once
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// Windows of an X display for GLX, for clients that have several or change them.
namespace software {

/// Returns the first configuration with these attributes; null if there is none.
[[nodiscard]] GLXFBConfig firstGlxConfig(Display *display, std::vector<int> attributes);
/// Returns the first configuration of RGBA8, 24 bits of depth and 8 of stencil that supports all of
/// `drawables` (GLX_WINDOW_BIT, ..) and has further attributes; null if there is none.
[[nodiscard]] GLXFBConfig chooseGlxConfig(Display *display, int drawables,
                                          const std::vector<int> &more = {GLX_DOUBLEBUFFER, True});

struct WindowOptions {
  int x = 0, y = 0;     ///< of its upper left corner, on the screen
  bool mapped = true;   ///< mapped at once
  bool cleared = false; ///< the server fills undrawn parts with black
};
[[nodiscard]] Window makeWindow(Display *display, GLXFBConfig config, int width, int height,
                                const WindowOptions &options = {});

/// Returns the window's visible content, RGBA8 with an alpha of 255, bottom row first; empty if the
/// server has no pixels of it. It makes no request before, so that it does not wait for GL's unsent
/// requests.
[[nodiscard]] std::vector<unsigned char> grabWindow(Display *display, Window window, int width,
                                                    int height);

} // namespace software
