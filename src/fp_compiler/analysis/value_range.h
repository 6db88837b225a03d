#pragma once
#include <array>
#include <limits>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::fp::analysis {

/// Bounds on one component of a value. They hold for whatever data the application passes.
struct ValueRange {
  float lo = -std::numeric_limits<float>::infinity(); ///< lower bound, unless NaN
  float hi = std::numeric_limits<float>::infinity();  ///< upper bound, unless NaN
  bool number = false;                                ///< the value is never NaN

  [[nodiscard]] bool notNegative() const { return number && lo >= 0.0f; }
  /// True if the value is neither infinite nor NaN. The margin allows for a host that reorders
  /// sums.
  [[nodiscard]] bool finite() const { return number && lo >= -0x1p126f && hi <= 0x1p126f; }
  [[nodiscard]] bool mayBeZero() const { return lo <= 0.0f && hi >= 0.0f; }
};

using ValueRange4 = std::array<ValueRange, 4>;

/// Returns the range of exactly \p value. NaN gives the unbounded range.
[[nodiscard]] ValueRange rangeOfNumber(float value);
/// Returns the range of a number in [lo, hi].
[[nodiscard]] ValueRange rangeBetween(float lo, float hi);
[[nodiscard]] ValueRange negated(const ValueRange &value);
[[nodiscard]] ValueRange saturated(const ValueRange &value);

/// Returns the range of an attribute component, as the instructions of the mode read it. Texture
/// coordinates, the fog coordinate and all vertex attributes come from the application. They may be
/// infinite. Fragment colours may too, if the application disables vertex colour clamping
/// (ARB_color_buffer_float). This function assumes that such colours do not exceed the range of a
/// half float. Half float is the largest colour buffer format short of single floats.
[[nodiscard]] ValueRange rangeOfAttribute(const ir::Attribute &attribute, ir::Language language,
                                          int component, Numerics numerics);

/// Returns the range of an instruction's result before _SAT.
[[nodiscard]] ValueRange4 rangeOfResult(const ir::Instruction &instruction,
                                        const std::array<ValueRange4, 3> &operands,
                                        Numerics numerics);

} // namespace arbiter::fp::analysis
