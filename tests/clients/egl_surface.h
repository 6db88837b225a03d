#pragma once
#include <EGL/egl.h>
#include <EGL/eglext.h>

/// Makes a pbuffer with a desktop GL context, through the EGL functions that the client found.
namespace clients {

struct Egl {
#define CLIENT_EGL_FUNCTIONS(X)                                                                    \
  X(GetDisplay)                                                                                    \
  X(Initialize)                                                                                    \
  X(BindAPI)                                                                                       \
  X(ChooseConfig)                                                                                  \
  X(CreatePbufferSurface)                                                                          \
  X(CreateContext)                                                                                 \
  X(MakeCurrent)                                                                                   \
  X(DestroyContext)                                                                                \
  X(DestroySurface) X(Terminate) X(SwapBuffers) X(GetProcAddress) X(ReleaseThread) X(GetError)
#define X(name) decltype(&::egl##name) name = nullptr;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
};

Egl loadEgl(void *(*get)(const char *name));

struct EglSurface {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;
  EGLSurface surface = EGL_NO_SURFACE;
  EGLContext context = EGL_NO_CONTEXT;
};

/// Opens a surface. platform: 0 for eglGetDisplay's default, else EGL_PLATFORM_SURFACELESS_MESA or
/// EGL_PLATFORM_DEVICE_EXT (the first device).
EglSurface openSurface(const Egl &egl, EGLenum platform = 0);
void closeSurface(const Egl &egl, EglSurface &surface);

} // namespace clients
