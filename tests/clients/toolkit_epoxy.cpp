/// Uses libepoxy, which resolves every function itself, by dlsym or by GetProcAddress. Its
/// functions are pointer variables, through which the client calls.
#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include "body.h"
#include "glx_window.h"

int main() {
  using namespace clients;
  const Glx glx = {epoxy_glXChooseVisual,   epoxy_glXCreateContext, epoxy_glXMakeCurrent,
                   epoxy_glXDestroyContext, epoxy_glXSwapBuffers,   epoxy_glXGetProcAddressARB};
  GlxWindow window = openWindow(glx);
  Gl gl;
#define X(name, result, parameters) gl.name = epoxy_gl##name;
  CLIENT_GL_FUNCTIONS(X)
#undef X
#define X(name, result, parameters) gl.name = epoxy_gl##name;
  CLIENT_ARB_FUNCTIONS(X)
#undef X
  const bool right = drawAndReport(gl, "epoxy");
  closeWindow(glx, window);
  return right ? 0 : 1;
}
