#pragma once
#include <cstdint>

#include "fp_compiler/ir/interface.h"

/// PK* and UP* of NV_fragment_program_option (3.11.5.32 to 3.11.5.46): packs numbers in the bits of
/// a float. Rounding is to nearest, ties to even. A NaN becomes a byte or a word of 0, or a NaN of
/// a half.
namespace arbiter::fp::ir {

enum class Packing : std::uint8_t { Half2, Unsigned2, Signed4, Unsigned4 };

/// Returns the bits in each component, as a float that may be a denormal or a NaN. The result is a
/// vector, because 32-bit x86 returns a float in a register that changes a signalling NaN.
[[nodiscard]] Vec4 packed(Packing packing, const Vec4 &value);
[[nodiscard]] Vec4 unpacked(Packing packing, float bits);

/// Converts a float to the bits of a 16-bit float. From 65520 on the half is an infinity.
[[nodiscard]] std::uint16_t halfOf(float value);

} // namespace arbiter::fp::ir
