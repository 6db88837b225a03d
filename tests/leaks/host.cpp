// A library that leaks, as a host's driver may.
#include <cstdlib>

namespace {
void *volatile g_kept; // so that no allocation is left out
}

extern "C" [[gnu::visibility("default")]] void hostLeaks() {
  for (int i = 0; i < 3; ++i)
    g_kept = std::malloc(100);
  g_kept = nullptr;
}
