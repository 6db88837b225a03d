#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/hw/names.h"
#include "fp_compiler/hw/profile.h"

/// What the readers of a profile's tables share; for those files alone, which are the only ones
/// that see the TOML library.
namespace arbiter::fp::hw {
/// Thrown where the TOML parser finds itself in a state that it holds to be impossible.
struct ParserBroken {};
constexpr void require(bool possible) {
  if (!possible)
    throw ParserBroken();
}
} // namespace arbiter::fp::hw

// toml++ 3.3 asserts, or in a release build assumes, what bad text can break ("[[["). In a library
// that lives in an application that must be an error, whatever the build type.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ::arbiter::fp::hw::require(bool(expr))
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_INT_CHARCONV 1
#define TOML_FLOAT_CHARCONV 1 // else it brings iostreams and locales into every application
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace arbiter::fp::hw {

/// Collects the first error, with its place.
struct Reader {
  std::string_view path;
  std::string error;

  bool fail(const toml::source_region &where, const std::string &text) {
    if (error.empty())
      error = std::string(path) + ":" + std::to_string(where.begin.line) + ":" +
              std::to_string(where.begin.column) + ": " + text;
    return false;
  }
};

/// `key = 96`, or `key = { value = 96, source = "where the number is from" }`: the value and the
/// source, which is the place in the file where none is given. Null after an error.
[[nodiscard]] const toml::node *readSourced(Reader &reader, const std::string &name,
                                            const toml::node &node, std::string &source);

/// The rows of a table by its keys. `seen`: those that it has are set.
[[nodiscard]] bool readTable(Reader &reader, Profile &profile, std::string_view name,
                             const toml::table &table, std::array<bool, kRowCount> &seen);

[[nodiscard]] bool readIdentity(Reader &reader, Profile &profile, const toml::table &table);

} // namespace arbiter::fp::hw
