#pragma once
#include <span>
#include <string>
#include <string_view>

/// Words for the errors of profiles.
namespace arbiter::fp::hw {

/// `; did you mean "api"?`, or nothing if none of the known is near.
[[nodiscard]] std::string meant(std::string_view typed, std::span<const std::string_view> known);

/// "api, native, state"
[[nodiscard]] std::string joined(std::span<const std::string_view> names);

/// Why there is no profile of that name.
[[nodiscard]] std::string unknownProfile(std::string_view name);

} // namespace arbiter::fp::hw
