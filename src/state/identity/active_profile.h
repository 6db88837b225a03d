#pragma once
#include <cstdint>

#include "fp_compiler/hw/profile.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

struct HostCaps;
enum class Target : std::uint8_t;

/// Returns the profile that ARBITER_PROFILE names. If none of that name loads, logs a warning and
/// returns the default. The profile lives as long as the process.
[[nodiscard]] const fp::hw::Profile &activeProfile();

/// Returns the numerics that the user asks for: ARBITER_NUMERICS, or else the profile's. A context
/// may get less, if its host cannot do them (CoreContext::numerics).
[[nodiscard]] fp::Numerics activeNumerics();
[[nodiscard]] std::string_view nameOf(fp::Numerics numerics);

/// Returns a profile's limits for a program target, clamped to what the host supports: a program
/// within the announced limits must draw.
[[nodiscard]] fp::Limits limitsUnder(const fp::hw::Profile &profile, Target target,
                                     const host::HostTable &host, const HostCaps &caps);

} // namespace arbiter::state
