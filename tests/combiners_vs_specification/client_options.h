#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>

/// What is drawn or issued: one state, or one sequence of commands, for each seed of [first, last).
struct Seeds {
  std::uint64_t first = 0;
  int count = 100;
  [[nodiscard]] std::uint64_t last() const { return first + std::uint64_t(count); }
};

/// `--name`, that sets a value.
struct Flag {
  const char *name, *help;
  bool &value;
};

/// Reads `[--first SEED] [--count N]` and the flags. Has the status of a client that is to end:
/// help was printed, or there are other words.
[[nodiscard]] std::optional<int> parseOptions(int argc, char **argv, const char *about,
                                              Seeds &seeds, std::initializer_list<Flag> flags = {});
