#include "glx_window.h"

#include <X11/Xutil.h>

#include "body.h"

namespace clients {

Glx loadGlx(void *(*get)(const char *name)) {
  Glx glx;
#define X(name)                                                                                    \
  glx.name = reinterpret_cast<decltype(glx.name)>(get("glX" #name));                               \
  if (!glx.name)                                                                                   \
    die("no function", "glX" #name);
  X(ChooseVisual)
  X(CreateContext)
  X(MakeCurrent)
  X(DestroyContext)
  X(SwapBuffers)
  X(GetProcAddressARB)
#undef X
  return glx;
}

GlxWindow openWindow(const Glx &glx, bool makeContext) {
  GlxWindow w;
  w.display = XOpenDisplay(nullptr);
  if (!w.display)
    die("no display");
  const int screen = DefaultScreen(w.display);
  int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 16, None};
  w.visual = glx.ChooseVisual(w.display, screen, attributes);
  if (!w.visual)
    die("no visual");
  const Window root = RootWindow(w.display, screen);
  XSetWindowAttributes set = {};
  set.colormap = XCreateColormap(w.display, root, w.visual->visual, AllocNone);
  w.window = XCreateWindow(w.display, root, 0, 0, 64, 64, 0, w.visual->depth, InputOutput,
                           w.visual->visual, CWColormap | CWBorderPixel, &set);
  XMapWindow(w.display, w.window);
  XSync(w.display, False);
  if (makeContext) {
    w.context = glx.CreateContext(w.display, w.visual, nullptr, True);
    if (!w.context || !glx.MakeCurrent(w.display, w.window, w.context))
      die("no context");
  }
  return w;
}

void closeWindow(const Glx &glx, GlxWindow &w) {
  glx.MakeCurrent(w.display, None, nullptr);
  if (w.context)
    glx.DestroyContext(w.display, w.context);
  XDestroyWindow(w.display, w.window);
  XFree(w.visual);
  XCloseDisplay(w.display);
  w = {};
}

} // namespace clients
