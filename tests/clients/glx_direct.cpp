/// Is linked with GL: libGL, or libOpenGL and libGLX; with -rpath; or as the only content of a
/// plugin.
#include "linked.h"

#ifdef CLIENT_IS_PLUGIN
extern "C" __attribute__((visibility("default"))) int runPlugin(const char *name)
#else
int main(int, char **name)
#endif
{
  using namespace clients;
  const Glx glx = linkedGlx();
  GlxWindow window = openWindow(glx);
#ifdef CLIENT_IS_PLUGIN
  const bool right = drawAndReport(linkedGl(), name);
#else
  const bool right = drawAndReport(linkedGl(), name[0]);
#endif
  glx.SwapBuffers(window.display, window.window);
  closeWindow(glx, window);
  return right ? 0 : 1;
}
