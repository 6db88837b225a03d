#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>

/// The seeds to test, [first, last): each gives one state, or one sequence of commands.
struct Seeds {
  std::uint64_t first = 0;
  int count = 100;
  [[nodiscard]] std::uint64_t last() const { return first + std::uint64_t(count); }
};

/// An option `--name` that sets a value.
struct Flag {
  const char *name, *help;
  bool &value;
};

/// Parses `[--first SEED] [--count N]` and the flags. Returns the exit status if the client must
/// end: help was printed, or there are other words.
[[nodiscard]] std::optional<int> parseOptions(int argc, char **argv, const char *about,
                                              Seeds &seeds, std::initializer_list<Flag> flags = {});
