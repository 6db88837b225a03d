#pragma once
#include <cstdint>

namespace arbiter::fp {

/// A half-open range of bytes [begin, end) in a program string. 32 bits suffice: the text limit is
/// 1 MiB (front/limits.h).
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool operator==(const Span &) const = default;
};

} // namespace arbiter::fp
