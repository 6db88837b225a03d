/// Uses EGL as newer Wine does: it takes only eglGetProcAddress from the library. By it, it finds
/// all functions of EGL and of GL of every version (EGL_KHR_client_get_all_proc_addresses), and it
/// selects a display by platform. It makes two contexts of one share group: the first is current to
/// a pbuffer, the second to a window if there are windows. argv[1]: x11 or surfaceless.
#include <cstring>
#include <initializer_list>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <dlfcn.h>

#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

constexpr const char *kProgram = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";

decltype(&::eglGetProcAddress) g_get = nullptr;

void *get(const char *name) { return reinterpret_cast<void *>(g_get(name)); }

template <typename Function> Function found(const char *name) {
  void *const function = get(name);
  if (!function)
    die("no function", name);
  return reinterpret_cast<Function>(function);
}
#define EGL(name) found<decltype(&::egl##name)>("egl" #name)

bool has(const char *extensions, const char *name) {
  const std::size_t length = std::strlen(name);
  for (const char *at = extensions; at && (at = std::strstr(at, name)); at += length)
    if ((at == extensions || at[-1] == ' ') && (at[length] == ' ' || !at[length]))
      return true;
  return false;
}

/// Opens a window with the config's visual, for an EGL surface.
Window openWindow(Display *display, VisualID visual) {
  XVisualInfo wanted = {};
  wanted.visualid = visual;
  int count = 0;
  XVisualInfo *const info = XGetVisualInfo(display, VisualIDMask, &wanted, &count);
  if (!info)
    die("the config has no visual");
  const Window root = RootWindow(display, info->screen);
  XSetWindowAttributes set = {};
  set.colormap = XCreateColormap(display, root, info->visual, AllocNone);
  const Window window = XCreateWindow(display, root, 0, 0, 64, 64, 0, info->depth, InputOutput,
                                      info->visual, CWColormap | CWBorderPixel, &set);
  XFree(info);
  XMapWindow(display, window);
  XSync(display, False);
  return window;
}

EGLConfig chosen(EGLDisplay display, EGLint surfaces) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           surfaces,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_STENCIL_SIZE,
                           8,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!EGL(ChooseConfig)(display, wanted, &config, 1, &count) || count < 1)
    die("no EGL config");
  return config;
}

} // namespace

int main(int argc, char **argv) {
  const bool windowed = argc > 1 && !std::strcmp(argv[1], "x11");
  void *const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library)
    die("dlopen:", dlerror());
  g_get = reinterpret_cast<decltype(g_get)>(dlsym(library, "eglGetProcAddress"));

  const char *const extensions = EGL(QueryString)(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  for (const char *name : {"EGL_KHR_client_get_all_proc_addresses", "EGL_EXT_platform_base",
                           windowed ? "EGL_KHR_platform_x11" : "EGL_MESA_platform_surfaceless"})
    if (!has(extensions, name))
      die("no client extension", name);

  Display *const x = windowed ? XOpenDisplay(nullptr) : nullptr;
  if (windowed && !x)
    die("no display");
  const EGLDisplay display = EGL(GetPlatformDisplay)(
      windowed ? EGL_PLATFORM_X11_KHR : EGL_PLATFORM_SURFACELESS_MESA, x, nullptr);
  if (display == EGL_NO_DISPLAY || !EGL(Initialize)(display, nullptr, nullptr) ||
      !EGL(BindAPI)(EGL_OPENGL_API))
    die("no EGL display");
  const EGLConfig config = chosen(display, EGL_PBUFFER_BIT | (windowed ? EGL_WINDOW_BIT : 0));

  const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
  const EGLSurface pbuffer = EGL(CreatePbufferSurface)(display, config, size);
  EGLSurface target = EGL_NO_SURFACE;
  Window window = 0;
  if (windowed) {
    EGLint visual = 0;
    EGL(GetConfigAttrib)(display, config, EGL_NATIVE_VISUAL_ID, &visual);
    window = openWindow(x, VisualID(visual));
    target = EGL(CreateWindowSurface)(display, config, window, nullptr);
  } else {
    target = EGL(CreatePbufferSurface)(display, config, size);
  }
  const EGLContext first = EGL(CreateContext)(display, config, EGL_NO_CONTEXT, nullptr);
  const EGLContext second = EGL(CreateContext)(display, config, first, nullptr);
  if (pbuffer == EGL_NO_SURFACE || target == EGL_NO_SURFACE || first == EGL_NO_CONTEXT ||
      second == EGL_NO_CONTEXT)
    die("no EGL surface or context");

  // Functions are looked up before any context is current, and serve both.
  const Gl gl = load(get);
  if (!EGL(MakeCurrent)(display, pbuffer, pbuffer, first))
    die("the first context");
  bool right = drawAndReport(gl, "first", 1.0f, true);
  GLuint program = 0;
  gl.GenProgramsARB(1, &program);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                      GLsizei(std::strlen(kProgram)), kProgram);
  gl.Finish();

  if (!EGL(MakeCurrent)(display, target, target, second))
    die("the second context");
  EGL(SwapInterval)(display, 0);
  for (int frame = 0; frame < 3; ++frame) {
    right &= drawAndReport(gl, windowed ? "x11" : "surfaceless", 0.5f, frame < 2);
    right &= EGL(SwapBuffers)(display, target) == EGL_TRUE || !windowed;
  }
  GLint length = 0;
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  gl.GetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
  if (length != GLint(std::strlen(kProgram)))
    die("a program of one context is not the other's");

  EGL(MakeCurrent)(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  EGL(DestroyContext)(display, first);
  EGL(DestroyContext)(display, second);
  EGL(DestroySurface)(display, pbuffer);
  EGL(DestroySurface)(display, target);
  EGL(Terminate)(display);
  if (x) {
    XDestroyWindow(x, window);
    XCloseDisplay(x);
  }
  return right ? 0 : 1;
}
