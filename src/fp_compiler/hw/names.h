#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Looks up names of profiles, and words the errors about profiles.
namespace arbiter::fp::hw {

/// Returns the other names of a built-in profile's card, such as "radeon9700".
[[nodiscard]] std::vector<std::string_view> aliasesOf(std::string_view builtin);

/// Returns the name of the built-in profile that `typed` names or is an alias of. Case, spaces and
/// dashes do not matter, the card's maker may stand before it, and "gf4" and "r9700" stand for
/// "geforce4" and "radeon9700". Returns an empty name if there is none.
[[nodiscard]] std::string_view builtinMeant(std::string_view typed);

/// Returns `; did you mean "api"?`, or an empty text if no known name is close.
[[nodiscard]] std::string meant(std::string_view typed, std::span<const std::string_view> known);

/// Returns the names as a list: "api, native, state".
[[nodiscard]] std::string joined(std::span<const std::string_view> names);

/// Returns an error that says why there is no profile of that name.
[[nodiscard]] std::string unknownProfile(std::string_view name);

} // namespace arbiter::fp::hw
