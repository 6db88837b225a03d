// Leaks, keeps or misuses memory as its first argument says, for leaks_test.py. The second is a
// library that stands in for a host.
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <string>
#include <vector>

namespace {

struct Node {
  std::vector<int> numbers;
};

// What the last call left on the stack is taken for a pointer in use.
[[gnu::noinline]] void overwrite() {
  volatile char area[4096];
  for (auto &byte : area)
    byte = 0;
}

[[gnu::noinline]] void leaks() {
  auto *const node = new Node;
  node->numbers.resize(40);
}

[[gnu::noinline]] void keepsOnPurpose() { new Node; }

[[gnu::noinline]] int misuses() {
  auto number = std::make_unique<int>(7);
  const volatile int *const freed = number.get();
  number.reset();
  return *freed;
}

[[gnu::noinline]] void leaksInHost(const char *path, bool unloads) {
  void *const library = dlopen(path, RTLD_NOW);
  reinterpret_cast<void (*)()>(dlsym(library, "hostLeaks"))();
  if (unloads)
    dlclose(library);
}

} // namespace

int main(int, char **arguments) {
  const std::string what = arguments[1];
  if (what == "leak")
    leaks();
  else if (what == "keep")
    keepsOnPurpose();
  else if (what == "host" || what == "unloaded")
    leaksInHost(arguments[2], what == "unloaded");
  else if (what == "misuse")
    return misuses();
  else if (what == "signal")
    return raise(SIGSEGV);
  overwrite();
  return 0;
}
