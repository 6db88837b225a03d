#pragma once
#include <string>

#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::r300 {

/// Changes one thing of \p code that should change what it does, and says what: a mistake that a
/// compiler could make. Empty where this code has nothing of the kind that was chosen.
[[nodiscard]] std::string mutate(fp::hw::r300::Code &code, fp::testing::Random &random);

} // namespace arbiter::r300
