#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace arbiter {

/// True if `count` bytes are equal. Numbers are not compared: a NaN equals itself, and -0 is not 0.
[[nodiscard]] inline bool sameBytes(const void *a, const void *b, std::size_t count) {
  return std::memcmp(a, b, count) == 0;
}

/// True if all bits are equal. Padding may make equal values differ.
template <typename T> [[nodiscard]] inline bool sameBits(const T &a, const T &b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return sameBytes(static_cast<const void *>(&a), static_cast<const void *>(&b), sizeof a);
}

} // namespace arbiter
