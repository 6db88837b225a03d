#pragma once
#include <cstdlib>

namespace arbiter::scene {

/// Returns how many hostile files a test makes: `usual`, multiplied by the environment's
/// HOSTILE_FILES for longer runs under the sanitizers.
[[nodiscard]] inline int hostileRounds(int usual) {
  const char *const times = std::getenv("HOSTILE_FILES");
  const int factor = times ? std::atoi(times) : 1;
  return usual * (factor > 0 ? factor : 1);
}

} // namespace arbiter::scene
