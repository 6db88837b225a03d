#pragma once
#include <cstdint>

namespace arbiter::state {

/// What is known in a context of its planes' enables, without a question to the host.
struct ClipPlanes {
  bool used = false; ///< one was enabled at some time: until then none can be
  bool known = true; ///< `enabled` is the host's answer since the last change
  bool enabled = false;
  std::uint8_t mask = 0; ///< a bit for each plane; where maskKnown, the host's answer likewise
  bool maskKnown = true;
};

} // namespace arbiter::state
