#pragma once
#include <cstdint>

namespace arbiter {

/// Families of processors by their vectors, each with all of the ones before: what x86-64 has at
/// least (and any other architecture), AVX2 with POPCNT, AVX-512 F and DQ.
enum class Vectors : std::uint8_t { Least, Avx2, Avx512 };

/// What code of this process that is compiled for several families may use: what this processor
/// has, and no more than ARBITER_CPU says.
[[nodiscard]] Vectors vectors();

} // namespace arbiter
