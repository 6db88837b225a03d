#pragma once
#include <cstdint>
#include <cstdlib>
#include <set>

#include "surface.h"

/// Chooses the commands of a random sequence. Command number i depends only on the seed and on i,
/// so that others can be left out.
namespace software {

/// Returns the random numbers of command `number` alone.
inline Random randomOf(std::uint64_t seed, int number) {
  Random random(seed * 1000003u + std::uint64_t(number));
  random.bits();
  return random;
}

/// Returns one of `all`, with a probability proportional to its member `weight`.
template <typename Commands>
const typename Commands::value_type &pickByWeight(const Commands &all, Random &random) {
  int sum = 0;
  for (const auto &command : all)
    sum += command.weight;
  int at = random.below(sum);
  for (const auto &command : all) {
    if (at < command.weight)
      return command;
    at -= command.weight;
  }
  return all.back();
}

/// Parses a list of numbers such as "3,17,20".
inline std::set<int> numbersOf(const char *list) {
  std::set<int> numbers;
  for (const char *at = list; *at;) {
    char *end = nullptr;
    numbers.insert(int(std::strtol(at, &end, 10)));
    at = *end == ',' ? end + 1 : "";
  }
  return numbers;
}

} // namespace software
