#pragma once

/// toml++ as the layer's libraries may use it; for readers of files alone, whose interfaces do not
/// show it.
namespace arbiter {
/// Thrown where the TOML parser finds itself in a state that it holds to be impossible.
struct TomlParserBroken {};
constexpr void requireOfToml(bool possible) {
  if (!possible)
    throw TomlParserBroken();
}
} // namespace arbiter

// toml++ 3.3 asserts, or in a release build assumes, what bad text can break ("[[["). In a library
// that lives in an application that must be an error, whatever the build type.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ::arbiter::requireOfToml(bool(expr))
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_INT_CHARCONV 1
#define TOML_FLOAT_CHARCONV 1 // else it brings iostreams and locales into every application
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
