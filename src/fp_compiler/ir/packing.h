#pragma once
#include <cstdint>

#include "fp_compiler/ir/interface.h"

/// PK* and UP* of NV_fragment_program_option (3.11.5.32 to 3.11.5.46): numbers in the bits of a
/// float. Rounding is to the nearest, ties to even; a NaN is a byte or a word of 0, and a half's
/// NaN.
namespace arbiter::fp::ir {

enum class Packing : std::uint8_t { Half2, Unsigned2, Signed4, Unsigned4 };

/// The bits in each component, as a float that may be a denormal or a NaN. Not by a float's value:
/// the registers that 32-bit x86 returns one in make another NaN of a signalling one.
[[nodiscard]] Vec4 packed(Packing packing, const Vec4 &value);
[[nodiscard]] Vec4 unpacked(Packing packing, float bits);

/// To a 16-bit float's bits and back; from 65520 on the half is an infinity.
[[nodiscard]] std::uint16_t halfOf(float value);
[[nodiscard]] float floatOf(std::uint16_t half);

} // namespace arbiter::fp::ir
