#pragma once
#include <cstdlib>

namespace arbiter::scene {

/// How many hostile files a test makes: `usual`, or as many times as the environment's
/// HOSTILE_FILES says, for longer runs under the sanitizers.
[[nodiscard]] inline int hostileRounds(int usual) {
  const char *const times = std::getenv("HOSTILE_FILES");
  const int factor = times ? std::atoi(times) : 1;
  return usual * (factor > 0 ? factor : 1);
}

} // namespace arbiter::scene
