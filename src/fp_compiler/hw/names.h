#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Names of profiles, and words for the errors of profiles.
namespace arbiter::fp::hw {

/// The other names of a built-in profile's card, such as "radeon9700".
[[nodiscard]] std::vector<std::string_view> aliasesOf(std::string_view builtin);

/// The built-in profile that is meant, by its name or an alias, in any case and with spaces and
/// dashes anywhere. Empty: none.
[[nodiscard]] std::string_view builtinMeant(std::string_view typed);

/// `; did you mean "api"?`, or nothing if none of the known is near.
[[nodiscard]] std::string meant(std::string_view typed, std::span<const std::string_view> known);

/// "api, native, state"
[[nodiscard]] std::string joined(std::span<const std::string_view> names);

/// Why there is no profile of that name.
[[nodiscard]] std::string unknownProfile(std::string_view name);

} // namespace arbiter::fp::hw
