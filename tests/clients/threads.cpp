/// Threads that draw at once, each in its own context of one share group, with program objects of
/// their own and one that all load parameters into. argv[1]: threads, argv[2]: draws of each.
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <dlfcn.h>

#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

Egl g_egl;
constexpr GLuint kSharedProgram = 4242;
constexpr const char *kShared = "!!ARBfp1.0\nMOV result.color, program.local[1];\nEND\n";

void *fromEgl(const char *name) {
  static void *const s_library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return dlsym(s_library, name);
}
void *byEgl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }

} // namespace

int main(int argc, char **argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 4;
  const int draws = argc > 2 ? std::atoi(argv[2]) : 200;
  g_egl = loadEgl(fromEgl);
  EglSurface base = openSurface(g_egl);
  const Gl gl = load(byEgl);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, kSharedProgram);
  gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                      GLsizei(std::strlen(kShared)), kShared);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < count; ++t)
    threads.emplace_back([&, t] {
      const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
      g_egl.BindAPI(EGL_OPENGL_API);
      const EGLSurface surface = g_egl.CreatePbufferSurface(base.display, base.config, size);
      const EGLContext context =
          g_egl.CreateContext(base.display, base.config, base.context, nullptr);
      if (!g_egl.MakeCurrent(base.display, surface, surface, context))
        die("no context on a thread");
      for (int i = 0; i < draws; ++i) {
        gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, kSharedProgram);
        gl.ProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, float(t), float(i), 0, 1);
        wrong += !drawAndReport(gl, "thread", 0.25f * float(1 + t % 4), true);
      }
      // Half of the threads end with their context current.
      if (t % 2 == 0)
        g_egl.MakeCurrent(base.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      g_egl.DestroyContext(base.display, context);
    });
  for (std::thread &thread : threads)
    thread.join();
  const bool right = drawAndReport(gl, "threads") && wrong == 0;
  closeSurface(g_egl, base);
  return right ? 0 : 1;
}
