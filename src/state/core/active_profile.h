#pragma once
#include "fp_compiler/hw/profile.h"

namespace arbiter::state {

/// The profile that ARBITER_PROFILE names; the default, with a warning in the log, where it names
/// none that loads. Lives as long as the process.
[[nodiscard]] const fp::hw::Profile &activeProfile();

/// The mode of arithmetic that is asked for: ARBITER_NUMERICS, or else the profile's. A context has
/// what its host can be given of it (Context::numerics).
[[nodiscard]] fp::Numerics activeNumerics();
[[nodiscard]] std::string_view nameOf(fp::Numerics numerics);

} // namespace arbiter::state
