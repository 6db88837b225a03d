#pragma once
#include <cstdint>

#include "fp_compiler/ir/semantics.h"

/// ir/semantics.h's Fp24 a second time, from the numbers: integers without error instead of singles
/// and their bits.
namespace arbiter::fp::proof {

constexpr std::uint32_t kPatterns = 1u << 24;

/// The number that a pattern of the chip's is: sign 1, exponent 7, mantissa 16 (numerics.h).
[[nodiscard]] float valueOf(std::uint32_t pattern);

/// fp24::rounded, fp24::truncated and fp24::colour, by their definition.
[[nodiscard]] float nearest(double value);
[[nodiscard]] float towardZero(double value);
[[nodiscard]] float colour(float value);

/// One step: the exact result to a single, and that to 24 bits; with Legacy's rule of zero.
[[nodiscard]] float product(float a, float b);
[[nodiscard]] float sum(float a, float b);

/// A function's result in long double, to a single and to 24 bits.
struct Function {
  float value = 0;
  /// The long double is so near to where a result turns into the next that its own error could
  /// decide: then `other` would do as well.
  bool open = false;
  float other = 0;
};
[[nodiscard]] Function function(ir::Opcode op, float x);

/// The result of an arithmetic opcode of fragment programs on 24-bit floats, in all components; the
/// components are `open` where a function's are.
struct Result {
  ir::Vec4 value = {};
  bool open = false;
};
[[nodiscard]] Result reference(ir::Opcode op, const ir::Operands &operands);

} // namespace arbiter::fp::proof
