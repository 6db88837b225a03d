#include "glx_windows.h"

#include <utility>

#include <X11/Xutil.h>

namespace software {

GLXFBConfig firstGlxConfig(Display *display, std::vector<int> attributes) {
  attributes.push_back(None);
  int count = 0;
  GLXFBConfig *const configs =
      glXChooseFBConfig(display, DefaultScreen(display), attributes.data(), &count);
  if (!configs)
    return nullptr;
  const GLXFBConfig first = count > 0 ? configs[0] : nullptr;
  XFree(configs);
  return first;
}

GLXFBConfig chooseGlxConfig(Display *display, int drawables, const std::vector<int> &more) {
  std::vector<int> wanted = {GLX_DRAWABLE_TYPE, drawables, GLX_RENDER_TYPE, GLX_RGBA_BIT};
  for (const int size :
       {GLX_RED_SIZE, GLX_GREEN_SIZE, GLX_BLUE_SIZE, GLX_ALPHA_SIZE, GLX_STENCIL_SIZE})
    wanted.insert(wanted.end(), {size, 8});
  wanted.insert(wanted.end(), {GLX_DEPTH_SIZE, 24});
  wanted.insert(wanted.end(), more.begin(), more.end());
  return firstGlxConfig(display, std::move(wanted));
}

Window makeWindow(Display *display, GLXFBConfig config, int width, int height,
                  const WindowOptions &options) {
  XVisualInfo *const visual = glXGetVisualFromFBConfig(display, config);
  const Window root = DefaultRootWindow(display);
  XSetWindowAttributes attributes = {};
  attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const unsigned long set = CWColormap | CWBorderPixel | (options.cleared ? CWBackPixel : 0);
  const Window window =
      XCreateWindow(display, root, options.x, options.y, unsigned(width), unsigned(height), 0,
                    visual->depth, InputOutput, visual->visual, set, &attributes);
  XFree(visual);
  if (options.mapped)
    XMapWindow(display, window);
  XSync(display, False);
  return window;
}

std::vector<unsigned char> grabWindow(Display *display, Window window, int width, int height) {
  std::vector<unsigned char> bytes;
  XImage *const image =
      XGetImage(display, window, 0, 0, unsigned(width), unsigned(height), AllPlanes, ZPixmap);
  for (int y = height - 1; image && y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      for (const int shift : {16, 8, 0})
        bytes.push_back(static_cast<unsigned char>(pixel >> shift));
      bytes.push_back(255);
    }
  }
  if (image)
    XDestroyImage(image);
  return bytes;
}

} // namespace software
