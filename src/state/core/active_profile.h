#pragma once
#include <cstdint>

#include "fp_compiler/hw/profile.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

struct HostCaps;
enum class Target : std::uint8_t;

/// The profile that ARBITER_PROFILE names; the default, with a warning in the log, where it names
/// none that loads. Lives as long as the process.
[[nodiscard]] const fp::hw::Profile &activeProfile();

/// The mode of arithmetic that is asked for: ARBITER_NUMERICS, or else the profile's. A context has
/// what its host can be given of it (Context::numerics).
[[nodiscard]] fp::Numerics activeNumerics();
[[nodiscard]] std::string_view nameOf(fp::Numerics numerics);

/// A profile's limits of a program target, no higher than the host can keep: what is promised must
/// draw.
[[nodiscard]] fp::Limits limitsUnder(const fp::hw::Profile &profile, Target target,
                                     const host::HostTable &host, const HostCaps &caps);

} // namespace arbiter::state
