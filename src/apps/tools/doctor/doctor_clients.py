"""C++ sources of clients that doctor_test.py compiles."""

GL_CALL = 'extern "C" void glFinish(); int main(int n, char **) { if (n > 9) glFinish(); }\n'
OPENS = ('#include <dlfcn.h>\nint main() {{ void *l = dlopen("{}", RTLD_NOW); '
         'return l && dlsym(l, "{}") ? 0 : 3; }}\n')
# Makes an EGL context without a window, with the core profile if requested, and draws nothing.
CLIENT = '''
#include <EGL/egl.h>
#include <EGL/eglext.h>
int main(int n, char **) {
  EGLDisplay d = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  eglInitialize(d, nullptr, nullptr);
  eglBindAPI(EGL_OPENGL_API);
  const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 0,
                         EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLContext c = eglCreateContext(d, nullptr, nullptr, n > 1 ? core : nullptr);
  return eglMakeCurrent(d, nullptr, nullptr, c) ? 0 : 1;
}
'''
# CLIENT, which also loads twice a program that is too long for the default profile's card.
LONG = CLIENT.replace('int main', '''#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <string>
int main''').replace('return eglMakeCurrent(d, nullptr, nullptr, c) ? 0 : 1;', '''
  if (!eglMakeCurrent(d, nullptr, nullptr, c)) return 1;
  std::string text = "!!ARBfp1.0TEMP r;\\n";
  for (int i = 0; i < 90; ++i) text += "MAD r, fragment.color, fragment.color, fragment.color;\\n";
  text += "MOV result.color, r;\\nEND";
  for (int i = 0; i < 2; ++i)
    glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, text.size(), text.c_str());
  return 0;''')
GLX_CLIENT = '''
#include <GL/glx.h>
int main() {
  Display *d = XOpenDisplay(nullptr);
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, None};
  XVisualInfo *v = glXChooseVisual(d, DefaultScreen(d), wanted);
  XSetWindowAttributes a = {};
  a.colormap = XCreateColormap(d, RootWindow(d, v->screen), v->visual, AllocNone);
  Window w = XCreateWindow(d, RootWindow(d, v->screen), 0, 0, 32, 32, 0, v->depth, InputOutput, v->visual,
                           CWColormap, &a);
  GLXContext c = glXCreateContext(d, v, nullptr, True);
  XSetErrorHandler([](Display *, XErrorEvent *) { return 0; });
  glXMakeCurrent(d, w, c);
  return 0;
}
'''
GLX_CALL = ('extern "C" int glXIsDirect(void *, void *);\n'
            'int main(int n, char **) { if (n > 9) glXIsDirect(nullptr, nullptr); }\n')
