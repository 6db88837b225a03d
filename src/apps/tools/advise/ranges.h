#pragma once
#include "apps/tools/advise/subject.h"
#include "fp_compiler/analysis/value_range.h"

namespace arbiter::tools::advise {

/// Returns the range of all values that an operand can have at the positions of \p mask, for any
/// input.
[[nodiscard]] fp::analysis::ValueRange rangeOf(const Subject &subject, std::uint32_t index,
                                               int operand, std::uint8_t mask);

} // namespace arbiter::tools::advise
