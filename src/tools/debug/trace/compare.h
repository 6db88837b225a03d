#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/debug/trace/trace.h"

/// Where two traces part.
namespace arbiter::tools::debug {

/// What counts as equal: |a - b| <= max(absolute, relative * max(|a|, |b|)). Two NaNs are equal,
/// and so are equal infinities.
struct Tolerance {
  float absolute = 0;
  float relative = 0;
};
[[nodiscard]] bool isEqual(float a, float b, const Tolerance &tolerance);
/// Components of \p mask that differ.
[[nodiscard]] std::uint8_t differing(const Vec4 &a, const Vec4 &b, std::uint8_t mask,
                                     const Tolerance &tolerance);

/// Rows of two traces that stand for each other.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// By opcode, write mask and texture, in the order of the rows: the longest common sequence;
/// between its members rows that were changed are paired in order, and what was added has no
/// partner.
[[nodiscard]] Pairs align(const Trace &a, const Trace &b);

struct Difference {
  std::size_t row = 0, other = 0;
  Both<Vec4> value;
  std::uint8_t components = 0; ///< that differ; 0 where KIL decides differently
  /// An operand that the two rows name alike and that holds another value, or one without a
  /// partner: "operand 2, k: (0.25, ..) here, (0.5, ..) there". Empty if there is none.
  std::string cause;
};

/// The first instruction whose value differs (of Trace's first arithmetic).
[[nodiscard]] std::optional<Difference> firstDifference(const Trace &a, const Trace &b,
                                                        const Tolerance &tolerance);

/// The name of the first result that differs; results that only one has differ.
[[nodiscard]] std::optional<std::string> differingResult(const Trace &a, const Trace &b,
                                                         const Tolerance &tolerance);

} // namespace arbiter::tools::debug
