#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/tools/debug/trace/trace.h"

/// Finds the first difference between two traces.
namespace arbiter::tools::debug {

/// Values are equal if |a - b| <= max(absolute, relative * max(|a|, |b|)). Two NaNs are equal, and
/// so are equal infinities.
struct Tolerance {
  float absolute = 0;
  float relative = 0;
};
[[nodiscard]] bool isEqual(float a, float b, const Tolerance &tolerance);
/// Returns the components of \p mask that differ.
[[nodiscard]] std::uint8_t differing(const Vec4 &a, const Vec4 &b, std::uint8_t mask,
                                     const Tolerance &tolerance);

/// Pairs of corresponding rows of two traces.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Pairs rows by their longest common sequence of opcode, write mask and texture. Between its
/// members, changed rows are paired in order; added rows have no partner.
[[nodiscard]] Pairs align(const Trace &a, const Trace &b);

struct Difference {
  std::size_t row = 0, other = 0;
  Both<Vec4> value;
  std::uint8_t components = 0; ///< the differing components; 0 if KIL decides differently
  /// The cause, if it is known: another opcode, other texels, or an operand with another value,
  /// such as "operand 2, k: (0.25, ..) here, (0.5, ..) there".
  std::string cause;
};

/// Returns the first instruction whose value differs in the traces' first arithmetic.
[[nodiscard]] std::optional<Difference> firstDifference(const Trace &a, const Trace &b,
                                                        const Tolerance &tolerance);

/// Returns the name of the first result that differs, or that only one trace has.
[[nodiscard]] std::optional<std::string> differingResult(const Trace &a, const Trace &b,
                                                         const Tolerance &tolerance);

} // namespace arbiter::tools::debug
