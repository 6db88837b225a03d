// Copies the extension string into a buffer of fixed size, as many programs of the era did. A page
// without permissions follows the buffer, so that a longer string always ends the process by
// SIGSEGV, not only if something important follows.
//
//   FIXED_BUFFER_BYTES=N client [WORDS...]
//
// Prints "GL_EXTENSIONS: " and the string with a newline into N bytes, as engines do that print it
// to their consoles. Without the variable it ends before it uses GL. Its words only serve matching
// by command line. With PROGRAM_INSTRUCTIONS=M it loads a fragment program of M instructions too,
// and ends with status 3 if that is refused.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <initializer_list>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace {

template <typename T> T function(void *library, const char *name) {
  return reinterpret_cast<T>(dlsym(library, name));
}

/// Returns the last `bytes` before an inaccessible page.
char *buffer(std::size_t bytes) {
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  const std::size_t whole = (bytes + page - 1) / page * page;
  char *const memory = static_cast<char *>(
      mmap(nullptr, whole + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  if (memory == MAP_FAILED || mprotect(memory + whole, page, PROT_NONE) != 0)
    return nullptr;
  return memory + whole - bytes;
}

template <typename T> T command(void *egl, const char *name) {
  return reinterpret_cast<T>(
      function<decltype(&eglGetProcAddress)>(egl, "eglGetProcAddress")(name));
}

bool loads(void *egl, int instructions) {
  std::string text = "!!ARBfp1.0\nTEMP r;\nMOV r, fragment.color;\n";
  for (int i = 2; i < instructions; ++i)
    text += "MAD r, r, r, r;\n";
  text += "MOV result.color, r;\nEND\n";
  command<PFNGLBINDPROGRAMARBPROC>(egl, "glBindProgramARB")(GL_FRAGMENT_PROGRAM_ARB, 1);
  command<PFNGLPROGRAMSTRINGARBPROC>(egl, "glProgramStringARB")(
      GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.c_str());
  return command<decltype(&glGetError)>(egl, "glGetError")() == GL_NO_ERROR;
}

} // namespace

int main() {
  const char *const size = std::getenv("FIXED_BUFFER_BYTES");
  if (!size)
    return 0;
  void *const egl = dlopen("libEGL.so.1", RTLD_NOW);
  if (!egl)
    return 77;
  const auto display = function<decltype(&eglGetPlatformDisplay)>(egl, "eglGetPlatformDisplay")(
      EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!function<decltype(&eglInitialize)>(egl, "eglInitialize")(display, nullptr, nullptr))
    return 77;
  function<decltype(&eglBindAPI)>(egl, "eglBindAPI")(EGL_OPENGL_API);
  const auto context = function<decltype(&eglCreateContext)>(egl, "eglCreateContext")(
      display, nullptr, EGL_NO_CONTEXT, nullptr);
  if (!function<decltype(&eglMakeCurrent)>(egl, "eglMakeCurrent")(display, EGL_NO_SURFACE,
                                                                  EGL_NO_SURFACE, context))
    return 77;
  const char *const instructions = std::getenv("PROGRAM_INSTRUCTIONS");
  if (instructions && !loads(egl, std::atoi(instructions)))
    return 3;
  const auto getString = command<decltype(&glGetString)>(egl, "glGetString");
  const auto *const extensions = reinterpret_cast<const char *>(getString(GL_EXTENSIONS));
  char *const text = buffer(std::size_t(std::atol(size)));
  if (!extensions || !text)
    return 1;
  // This avoids sprintf(), which a hardened C library may truncate.
  char *to = text;
  for (const char *part : {"GL_EXTENSIONS: ", extensions, "\n"})
    while (*part)
      *to++ = *part++;
  *to = 0;
  std::printf("%zu\n", std::size_t(to - text));
  return 0;
}
