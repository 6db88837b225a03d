/// Draws in several threads at once, each in its own context of one share group. Each thread has
/// program objects of its own, and all load parameters into a common one. All share a vertex
/// program and a list, and have lists of their own that come and go. argv[1]: threads, argv[2]:
/// draws of each.
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

constexpr GLuint kSharedVertices = 4243;
constexpr GLuint kSharedList = 4244;
constexpr const char *kVertices = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                                  "MUL result.color, vertex.color, program.local[0];\nEND\n";

void *fromEgl(const char *name) {
  static void *const s_library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  return dlsym(s_library, name);
}
void *byEgl(const char *name) { return reinterpret_cast<void *>(g_egl.GetProcAddress(name)); }

/// The functions that threads need beyond the client's body.
struct Lists {
  GLuint (*Gen)(GLsizei) = nullptr;
  void (*New)(GLuint, GLenum) = nullptr;
  void (*End)() = nullptr;
  void (*Call)(GLuint) = nullptr;
  void (*Delete)(GLuint, GLsizei) = nullptr;
};
template <typename Function> void loadOne(Function *&function, const char *name) {
  function = reinterpret_cast<Function *>(byEgl(name));
  if (!function)
    die("no function", name);
}
Lists loadLists() {
  Lists lists;
  loadOne(lists.Gen, "glGenLists");
  loadOne(lists.New, "glNewList");
  loadOne(lists.End, "glEndList");
  loadOne(lists.Call, "glCallList");
  loadOne(lists.Delete, "glDeleteLists");
  return lists;
}

void loadProgram(const Gl &gl, GLenum target, GLuint name, const char *text) {
  gl.BindProgramARB(target, name);
  gl.ProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
}

void quad(const Gl &gl) {
  gl.Color4f(1, 1, 1, 1);
  gl.Begin(GL_QUADS);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(1, -1);
  gl.Vertex2f(1, 1);
  gl.Vertex2f(-1, 1);
  gl.End();
}

/// Draws by a list of the thread's own that calls the shared list, which binds the shared programs.
/// The thread's fragments identify it. Returns true if they are right.
bool drawByLists(const Gl &gl, const Lists &lists, GLuint program, int thread) {
  const float own = float(thread % 4 + 1) / 5;
  const GLuint list = lists.Gen(1);
  lists.New(list, GL_COMPILE);
  lists.Call(kSharedList);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  gl.ProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, own, 0.5f, 0, 1);
  quad(gl);
  gl.Disable(GL_VERTEX_PROGRAM_ARB);
  gl.Disable(GL_FRAGMENT_PROGRAM_ARB);
  lists.End();
  gl.Clear(GL_COLOR_BUFFER_BIT);
  lists.Call(list);
  unsigned char pixel[4] = {};
  gl.ReadPixels(16, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  lists.Delete(list, 1);
  return std::abs(pixel[0] - int(own * 255 + 0.5f)) <= 1 && std::abs(pixel[1] - 128) <= 1;
}

} // namespace

int main(int argc, char **argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 4;
  const int draws = argc > 2 ? std::atoi(argv[2]) : 200;
  g_egl = loadEgl(fromEgl);
  EglSurface base = openSurface(g_egl);
  const Gl gl = load(byEgl);
  const Lists lists = loadLists();
  loadProgram(gl, GL_FRAGMENT_PROGRAM_ARB, kSharedProgram, kShared);
  loadProgram(gl, GL_VERTEX_PROGRAM_ARB, kSharedVertices, kVertices);
  gl.ProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 1, 1, 1, 1);
  lists.New(kSharedList, GL_COMPILE);
  gl.BindProgramARB(GL_VERTEX_PROGRAM_ARB, kSharedVertices);
  gl.Enable(GL_VERTEX_PROGRAM_ARB);
  gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, kSharedProgram);
  gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
  quad(gl);
  lists.End();
  gl.Finish();
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
      const GLuint own = GLuint(5000 + t);
      loadProgram(gl, GL_FRAGMENT_PROGRAM_ARB, own, kShared);
      for (int i = 0; i < draws; ++i) {
        gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, kSharedProgram);
        gl.ProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, float(t), float(i), 0, 1);
        wrong += !drawAndReport(gl, "thread", 0.25f * float(1 + t % 4), true);
        wrong += !drawByLists(gl, lists, own, t);
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
