#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/flags.h"

/// Defaults for single programs (docs/use/defaults.md). Their settings apply unless the environment
/// sets others. They are read from TOML files, whose entries say which programs they apply to and
/// what they set.
namespace arbiter::defaults {

/// A setting that an entry may have. Its key in the file is the variable's name without ARBITER_,
/// in lower case.
struct Key {
  std::string name; ///< "extensions_max_length"
  Env variable;
};
/// Returns all keys, in the order of the files' documentation.
[[nodiscard]] std::span<const Key> keys();

/// The value of one key in an entry, as the text that the variable would have. An empty text
/// ("default" in the file) restores the layer's own default, whatever an earlier entry says.
struct Value {
  Env variable = Env::Profile;
  std::string text;
  std::uint32_t line = 0;
};

/// The programs that an entry applies to. Each condition that is present must hold, by one of its
/// patterns.
struct Match {
  std::vector<std::string> names;   ///< of the executable, without its folder
  std::vector<std::string> paths;   ///< of the executable, absolute
  std::vector<std::string> windows; ///< of the .exe, without its folder, case-insensitive
  std::vector<std::string> hashes;  ///< XXH3 of the file, 128 bits, as 32 hexadecimal digits
};

struct Entry {
  std::string title;
  Match match;
  std::vector<Value> values;
  std::vector<std::string> sources; ///< addresses of pages that document the program's fault
  std::string note;
  std::string file; ///< as the file was opened
  std::uint32_t line = 0;
};

/// The content of a file. Each error is one line, "FILE:LINE:COLUMN: text". The faulty part is left
/// out, and the rest applies.
struct File {
  std::vector<Entry> entries;
  std::vector<std::string> errors;
};

/// Parses a file's text. Paths of profiles become absolute, relative to the file's folder. Text
/// that is not TOML yields one error and no entry.
[[nodiscard]] File parseFile(std::string_view text, const std::string &path);

/// A file is expected to hold about a page of text; a larger one is a mistake.
inline constexpr std::size_t kMaxFileBytes = 1u << 20;

/// Reads and parses a regular file. A file that cannot be read yields one error, "FILE: text".
[[nodiscard]] File readFile(const std::string &path);

} // namespace arbiter::defaults
