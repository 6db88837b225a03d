#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/hw/names.h"
#include "fp_compiler/hw/profile.h"
#include "util/toml.h"

/// Helpers for the readers of a profile's tables. Only those files include the TOML library.
namespace arbiter::fp::hw {

/// Collects the first error, with its place in the file.
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

/// Reads `key = 96`, or `key = { value = 96, source = "where the number is from" }`.
/// \param source set to the given source, or else to the place in the file
/// \returns the value, or nullptr after an error.
[[nodiscard]] const toml::node *readSourced(Reader &reader, const std::string &name,
                                            const toml::node &node, std::string &source);

/// Reads the rows of a table.
/// \param seen set to true for each row that the table has
[[nodiscard]] bool readTable(Reader &reader, Profile &profile, std::string_view name,
                             const toml::table &table, std::array<bool, kRowCount> &seen);

[[nodiscard]] bool readIdentity(Reader &reader, Profile &profile, const toml::table &table);

} // namespace arbiter::fp::hw
