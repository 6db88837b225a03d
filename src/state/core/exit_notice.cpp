#include "state/core/exit_notice.h"

#include <atomic>
#include <cstdlib>

namespace arbiter::state {

namespace {
std::atomic<bool> g_began{false};
}

void watchExit() {
  // If the handler cannot be registered, exits go unnoticed.
  static const bool s_watched = std::atexit([] { g_began.store(true); }) == 0;
  static_cast<void>(s_watched);
}

bool exitBegan() { return g_began.load(std::memory_order_relaxed); }

} // namespace arbiter::state
