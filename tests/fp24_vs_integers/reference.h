#pragma once
#include <cstdint>

#include "fp_compiler/ir/semantics.h"

/// Implements ir/semantics.h's Fp24 a second time, with exact integers instead of singles and their
/// bits.
namespace arbiter::fp::proof {

constexpr std::uint32_t kPatterns = 1u << 24;

/// Returns the number of a pattern of the chip: sign 1, exponent 7, mantissa 16 (numerics.h).
[[nodiscard]] float valueOf(std::uint32_t pattern);

/// These implement fp24::rounded, fp24::truncated and fp24::colour by their definition.
[[nodiscard]] float nearest(double value);
[[nodiscard]] float towardZero(double value);
[[nodiscard]] float color(float value);

/// These compute one step: the exact result is rounded to a single, then to 24 bits; with Legacy's
/// rule of zero.
[[nodiscard]] float product(float a, float b);
[[nodiscard]] float sum(float a, float b);

/// The result of a function in long double, rounded to a single and to 24 bits.
struct Function {
  float value = 0;
  /// True if the long double is so near to a rounding boundary that its own error could decide;
  /// `other` is then right too.
  bool open = false;
  float other = 0;
};
[[nodiscard]] Function function(ir::Opcode op, float x);

/// The result of an arithmetic opcode of fragment programs on 24-bit floats, in all components. The
/// components are `open` if a function's are.
struct Result {
  ir::Vec4 value = {};
  bool open = false;
};
[[nodiscard]] Result reference(ir::Opcode op, const ir::Operands &operands);

} // namespace arbiter::fp::proof
