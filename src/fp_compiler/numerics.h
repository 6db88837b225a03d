#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// The arithmetic of a program, and the number formats that it needs.
namespace arbiter::fp {

/// Host    IEEE single precision, as ir/semantics.h states it.
/// Legacy  Host, but a product with a zero factor is zero, whatever the other factor, in every
///         opcode that multiplies. The chips of the time did so, and programs rely on it.
/// Fp24    Legacy on the R300's numbers: every value is a 24-bit float (below). Vertex programs
///         have no such unit and follow Legacy.
/// Fx9     Legacy, but NVIDIA's register combiners use whole numbers of 255ths in [-1,1]: "9-bit
///         signed fixed-point" (NV_texture_shader, table of 3.8). The IR made from combiners
///         contains the rounding (combiners/values.h) and follows Legacy.
enum class Numerics : std::uint8_t { Host, Legacy, Fp24, Fx9 };

/// The names in ARBITER_NUMERICS and in profiles, in the order of the enumerators.
inline constexpr std::array<std::string_view, 4> kNumericsNames = {"host", "legacy", "fp24", "fx9"};
[[nodiscard]] std::optional<Numerics> numericsNamed(std::string_view name);

/// Returns the arithmetic of instructions in the mode. Fx9 is not an instruction's arithmetic.
[[nodiscard]] constexpr Numerics ofInstructions(Numerics asked) {
  return asked == Numerics::Fx9 ? Numerics::Legacy : asked;
}

/// The 24-bit float of the R300: sign 1, exponent 7 (bias 63), mantissa 16. It is stored in an IEEE
/// single with exactly that value.
///   value      (-1)^s * 2^(e - 63) * (1 + m / 2^16) for 1 <= e <= 126
///   e = 0      zero of the sign, whatever the mantissa: there are no denormals
///   e = 127    infinity for m = 0, else NaN. The chip's behaviour there is not documented;
///   programs
///              of the time need an infinity, so that RCP of 0, times 0 is 0.
namespace fp24 {
inline constexpr int kMantissaBits = 16;
inline constexpr int kBias = 63;
inline constexpr float kGreatest = 0x1.FFFFp63f;
inline constexpr float kLeastNormal = 0x1p-62f;

/// Rounds to nearest, ties to even. The mantissa is rounded before the range is checked: above
/// kGreatest is an infinity, below kLeastNormal a zero of the sign.
[[nodiscard]] float rounded(float value);
/// Rounds toward zero, as constants and parameters are loaded. A finite value that is too large
/// becomes kGreatest; an infinity stays one.
[[nodiscard]] float truncated(float value);
/// Rounds an interpolated colour: clamps to [0,1] (NaN is 0), rounds to a multiple of 1/4095, then
/// applies rounded(). The steps are in singles: times 4095, to the nearest integer (ties to even),
/// times 1/4095. There is no division, because hosts may be inexact in it.
[[nodiscard]] float color(float value);
} // namespace fp24

} // namespace arbiter::fp
