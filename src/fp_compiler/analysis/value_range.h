#pragma once
#include <array>
#include <limits>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::fp::analysis {

/// What is known of one component of a value, whatever the application does.
struct ValueRange {
  float lo = -std::numeric_limits<float>::infinity(); ///< a value that is a number is not below
  float hi = std::numeric_limits<float>::infinity();  ///< nor above
  bool number = false;                                ///< it is no NaN

  [[nodiscard]] bool notNegative() const { return number && lo >= 0.0f; }
  /// Neither infinite nor NaN, with room for what a host gains by summing in another order.
  [[nodiscard]] bool finite() const { return number && lo >= -0x1p126f && hi <= 0x1p126f; }
  [[nodiscard]] bool mayBeZero() const { return lo <= 0.0f && hi >= 0.0f; }
};

using ValueRange4 = std::array<ValueRange, 4>;

/// Exactly \p value, or nothing of a NaN.
[[nodiscard]] ValueRange rangeOfNumber(float value);
/// A number of [lo, hi].
[[nodiscard]] ValueRange rangeBetween(float lo, float hi);
[[nodiscard]] ValueRange negated(const ValueRange &value);
[[nodiscard]] ValueRange saturated(const ValueRange &value);

/// An attribute's component, as the mode's instructions read it. Texture coordinates, the fog
/// coordinate and all attributes of vertices are the application's, infinities included. So, in
/// principle, are the colours of an application that turns the clamp of vertices' colours off
/// (ARB_color_buffer_float); of those it is taken that they are no larger than a half float can
/// hold, the largest that a colour buffer beside single floats has.
[[nodiscard]] ValueRange rangeOfAttribute(const ir::Attribute &attribute, ir::Language language,
                                          int component, Numerics numerics);

/// The result of an instruction before _SAT.
[[nodiscard]] ValueRange4 rangeOfResult(const ir::Instruction &instruction,
                                        const std::array<ValueRange4, 3> &operands,
                                        Numerics numerics);

} // namespace arbiter::fp::analysis
