/// Draws, then forks and executes itself, which draws too: the environment must pass the layer on.
#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

#define GL_GLEXT_PROTOTYPES
#include "body.h"
#include "egl_surface.h"

using namespace clients;

namespace {

void *getProc(const char *name) { return reinterpret_cast<void *>(eglGetProcAddress(name)); }

bool draw(const char *name) {
  Egl egl;
#define X(name) egl.name = ::egl##name;
  CLIENT_EGL_FUNCTIONS(X)
#undef X
  EglSurface surface = openSurface(egl);
  const bool right = drawAndReport(load(getProc), name);
  closeSurface(egl, surface);
  return right;
}

} // namespace

int main(int argc, char **argv) {
  if (argc > 1 && !std::strcmp(argv[1], "child"))
    return draw("child") ? 0 : 1;
  const bool right = draw("parent");
  const pid_t child = fork();
  if (child == 0) {
    execl("/proc/self/exe", argv[0], "child", nullptr);
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
    die("fork");
  return right && WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : 1;
}
