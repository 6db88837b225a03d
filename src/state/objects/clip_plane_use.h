#pragma once
#include <cstdint>

namespace arbiter::state {

/// Holds what a context knows about its enabled user clip planes without querying the host.
struct ClipPlanes {
  bool used = false; ///< true once a plane was enabled; before that none can be
  bool known = true; ///< true if `enabled` is the host's current answer
  bool enabled = false;
  std::uint8_t mask = 0; ///< one bit for each plane; valid if maskKnown
  bool maskKnown = true;
};

} // namespace arbiter::state
