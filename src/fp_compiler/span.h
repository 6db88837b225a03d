#pragma once
#include <cstdint>

namespace arbiter::fp {

/// A half-open range of bytes [begin, end) in a program string. 32 bits are enough, because a text
/// has at most 1 MiB (fp_compiler/limits.h).
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool operator==(const Span &) const = default;
};

} // namespace arbiter::fp
