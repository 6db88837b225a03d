#pragma once
#include <cstdint>

namespace arbiter {

/// Processor families by vector width; each includes the ones before. Least is the x86-64 baseline,
/// or any other architecture. Avx2 includes POPCNT, Avx512 includes F and DQ.
enum class Vectors : std::uint8_t { Least, Avx2, Avx512 };

/// Returns the best family that this processor has, limited by ARBITER_CPU.
[[nodiscard]] Vectors vectors();

} // namespace arbiter
