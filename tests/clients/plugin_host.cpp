/// Loads a plugin that is linked with libGL: argv[1] its path, argv[2] "local" or "deepbind".
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <cstdio>
#include <cstring>

#include <dlfcn.h>

int main(int argc, char **argv) {
  if (argc < 3)
    return 3;
  const int bind = std::strcmp(argv[2], "deepbind") ? 0 : RTLD_DEEPBIND;
  void *const plugin = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL | bind);
  auto *const run =
      plugin ? reinterpret_cast<int (*)(const char *)>(dlsym(plugin, "runPlugin")) : nullptr;
  if (!run) {
    std::fprintf(stderr, "client: %s\n", dlerror());
    return 3;
  }
  return run(argv[2]);
}
