#pragma once
#include "fp_compiler/analysis/value_range.h"
#include "tools/advise/subject.h"

namespace arbiter::tools::advise {

/// What is known of what an operand reads at the positions of \p mask, whatever the application
/// does: the hull of them.
[[nodiscard]] fp::analysis::ValueRange rangeOf(const Subject &subject, std::uint32_t index,
                                               int operand, std::uint8_t mask);

} // namespace arbiter::tools::advise
