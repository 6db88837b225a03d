#pragma once
#include <string>

#include "fp_compiler/hw/r300/machine.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::r300 {

/// Changes one thing in \p code that should change its effect, like a compiler's mistake, and
/// returns a description. Returns "" if the code has nothing of the chosen kind.
[[nodiscard]] std::string mutate(fp::hw::r300::Code &code, fp::testing::Random &random);

} // namespace arbiter::r300
