/// Uses GLEW: the core is linked, the ARB functions are GLEW's pointers.
#include <GL/glew.h>
#include <GL/glxew.h>

#include "body.h"
#include "glx_window.h"

int main() {
  using namespace clients;
  const Glx glx = {::glXChooseVisual,   ::glXCreateContext, ::glXMakeCurrent,
                   ::glXDestroyContext, ::glXSwapBuffers,   ::glXGetProcAddressARB};
  GlxWindow window = openWindow(glx);
  if (glewInit() != GLEW_OK)
    die("glewInit");
  if (!GLEW_ARB_fragment_program)
    die("GLEW sees no ARB_fragment_program");
  Gl gl;
#define X(name, result, parameters) gl.name = ::gl##name;
  CLIENT_GL_FUNCTIONS(X)
#undef X
#define X(name, result, parameters) gl.name = ::__glew##name;
  CLIENT_ARB_FUNCTIONS(X)
#undef X
  const bool right = drawAndReport(gl, "glew");
  closeWindow(glx, window);
  return right ? 0 : 1;
}
