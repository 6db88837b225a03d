#pragma once

/// Configures toml++ for the layer's libraries. Only sources that read files include it; their
/// interfaces do not expose it.
namespace arbiter {
/// Thrown if the TOML parser reaches a state that it asserts to be impossible.
struct TomlParserBroken {};
constexpr void requireOfToml(bool possible) {
  if (!possible)
    throw TomlParserBroken();
}
} // namespace arbiter

// toml++ 3.3 asserts, or in a release build assumes, conditions that bad text can break ("[[["). In
// a library inside an application that must be an error, in every build type.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ::arbiter::requireOfToml(bool(expr))
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_INT_CHARCONV 1
#define TOML_FLOAT_CHARCONV 1 // otherwise it brings iostreams and locales into every application
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
