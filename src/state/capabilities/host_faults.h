#pragma once
#include <cstdint>
#include <string_view>

/// Known faults of hosts, by driver and release (host_faults.def).
namespace arbiter::state {

enum class HostFault : std::uint8_t {
#define ARBITER_HOST_FAULT(Enumerator, driver, first, last, doc) Enumerator,
#include "state/capabilities/host_faults.def"
#undef ARBITER_HOST_FAULT
};
[[nodiscard]] constexpr std::uint32_t bitOf(HostFault fault) { return 1u << unsigned(fault); }

/// Returns a driver's release as 100 times its first number plus its second: 2302 for "Mesa
/// 23.2.1". Returns 0 if GL_VERSION names another driver.
[[nodiscard]] int releaseOf(std::string_view version, std::string_view driver);
/// Returns the bits of the faults that a host with this GL_VERSION has.
[[nodiscard]] std::uint32_t faultsOf(std::string_view version);

} // namespace arbiter::state
