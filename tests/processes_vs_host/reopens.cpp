// A program that is not linked with GL: it opens the library, draws, closes it, and does so again,
// as programs with drawing plugins do. The layer's state in the process must survive the unloading
// of libGL.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>

namespace {

constexpr int kSide = 32;

void need(bool good, const char *what) {
  if (good)
    return;
  std::fprintf(stderr, "foreign: %s failed\n", what);
  std::_Exit(4);
}

/// Opens libGL and closes it at the end.
class Library {
public:
  Library() : m_handle(dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL)) {
    need(m_handle != nullptr, "libGL");
  }
  ~Library() { dlclose(m_handle); }
  Library(const Library &) = delete;
  Library &operator=(const Library &) = delete;

  template <typename Function> Function *find(Function *, const char *name) const {
    void *const found = dlsym(m_handle, name);
    need(found != nullptr, name);
    return reinterpret_cast<Function *>(found);
  }

private:
  void *m_handle;
};
#define FIND(name) const auto name = library.find(static_cast<decltype(&::name)>(nullptr), #name)

constexpr char kProgram[] =
    "!!ARBfp1.0\nMUL result.color, fragment.color, {0.5, 1, 0.25, 1};\nEND\n";

void draw(const Library &library) {
  FIND(glClearColor);
  FIND(glClear);
  FIND(glEnable);
  FIND(glColor4f);
  FIND(glRectf);
  FIND(glReadPixels);
  FIND(glGetError);
  FIND(glXGetProcAddress);
  FIND(glFinish);
  const auto load = reinterpret_cast<PFNGLPROGRAMSTRINGARBPROC>(
      glXGetProcAddress(reinterpret_cast<const GLubyte *>("glProgramStringARB")));
  const auto bind = reinterpret_cast<PFNGLBINDPROGRAMARBPROC>(
      glXGetProcAddress(reinterpret_cast<const GLubyte *>("glBindProgramARB")));
  need(load && bind, "the functions of programs");
  glClearColor(0.125f, 0.25f, 0.5f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  bind(GL_FRAGMENT_PROGRAM_ARB, 1);
  load(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof kProgram - 1, kProgram);
  glColor4f(1.0f, 0.5f, 1.0f, 1.0f);
  glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
  glFinish();
  unsigned char pixels[kSide][kSide][4];
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  need(glGetError() == GL_NO_ERROR, "a GL command");
  std::printf("picture ");
  for (int y = 2; y < kSide; y += 4)
    for (int x = 2; x < kSide; x += 4)
      std::printf("%02x%02x%02x", pixels[y][x][0], pixels[y][x][1], pixels[y][x][2]);
  std::printf("\n");
  std::fflush(stdout);
}

/// Opens GL, draws and closes everything. The display must be closed first, as libGL hooks into it.
void openAndDraw() {
  const Library library;
  FIND(glXChooseVisual);
  FIND(glXCreateContext);
  FIND(glXMakeCurrent);
  FIND(glXDestroyContext);
  FIND(glXSwapBuffers);
  Display *const display = XOpenDisplay(nullptr);
  need(display != nullptr, "display");
  int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, None};
  XVisualInfo *const visual = glXChooseVisual(display, DefaultScreen(display), attributes);
  need(visual != nullptr, "visual");
  XSetWindowAttributes set = {};
  const Window root = DefaultRootWindow(display);
  set.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const Window window =
      XCreateWindow(display, root, 0, 0, kSide, kSide, 0, visual->depth, InputOutput,
                    visual->visual, CWColormap | CWBorderPixel, &set);
  XMapWindow(display, window);
  const GLXContext context = glXCreateContext(display, visual, nullptr, True);
  need(context && glXMakeCurrent(display, window, context), "context");
  for (int i = 0; i < 3; ++i) {
    draw(library);
    glXSwapBuffers(display, window);
  }
  glXMakeCurrent(display, None, nullptr);
  glXDestroyContext(display, context);
  XDestroyWindow(display, window);
  XCloseDisplay(display);
}

} // namespace

int main(int count, char **) {
  if (count == 1)
    return 0;
  for (int i = 0; i < 3; ++i)
    openAndDraw();
  return 0;
}
