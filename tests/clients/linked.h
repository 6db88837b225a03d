#pragma once
/// The GL and GLX functions as the linker bound them, for clients that link with them.
#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "glx_window.h"

namespace clients {

inline void *linkedProc(const char *name) {
  return reinterpret_cast<void *>(glXGetProcAddressARB(reinterpret_cast<const GLubyte *>(name)));
}

/// libOpenGL exports only the core, so that the ARB functions are looked up.
inline Gl linkedGl() {
  Gl gl;
#define X(name, result, parameters) gl.name = ::gl##name;
  CLIENT_GL_FUNCTIONS(X)
#undef X
#ifdef CLIENT_LINKS_ARB
#define X(name, result, parameters) gl.name = ::gl##name;
  CLIENT_ARB_FUNCTIONS(X)
#undef X
#else
  loadArb(gl, linkedProc);
#endif
  return gl;
}

inline Glx linkedGlx() {
  return {glXChooseVisual,   glXCreateContext, glXMakeCurrent,
          glXDestroyContext, glXSwapBuffers,   glXGetProcAddressARB};
}

} // namespace clients
