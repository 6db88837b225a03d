#pragma once
#include "fp_compiler/hw/profile.h"

namespace arbiter::state {

/// The profile that ARBITER_PROFILE names; the default, with a warning in the log, where it names
/// none that loads. Lives as long as the process.
[[nodiscard]] const fp::hw::Profile &activeProfile();

} // namespace arbiter::state
