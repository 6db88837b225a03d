#pragma once
#ifndef EPOXY_GLX_H
#include <GL/glx.h>
#endif

/// Opens a window with a GLX context, through the GLX functions that the client found.
namespace clients {

struct Glx {
  XVisualInfo *(*ChooseVisual)(Display *, int, int *) = nullptr;
  GLXContext (*CreateContext)(Display *, XVisualInfo *, GLXContext, Bool) = nullptr;
  Bool (*MakeCurrent)(Display *, GLXDrawable, GLXContext) = nullptr;
  void (*DestroyContext)(Display *, GLXContext) = nullptr;
  void (*SwapBuffers)(Display *, GLXDrawable) = nullptr;
  void (*(*GetProcAddressARB)(const GLubyte *))() = nullptr;
};

Glx loadGlx(void *(*get)(const char *name));

struct GlxWindow {
  Display *display = nullptr;
  XVisualInfo *visual = nullptr;
  Window window = 0;
  GLXContext context = nullptr;
};

/// Opens the display and a window of 64x64. Exits the client if it cannot.
GlxWindow openWindow(const Glx &glx, bool makeContext = true);
/// Releases and destroys the context, and closes the window and display.
void closeWindow(const Glx &glx, GlxWindow &window);

} // namespace clients
