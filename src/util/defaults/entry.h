#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/flags.h"

/// Defaults of single programs: settings that hold for a program unless the environment has others
/// (docs/use/defaults.md). Read from TOML files; an entry says which programs it is for, and what
/// it sets.
namespace arbiter::defaults {

/// A setting that an entry may have: its key in the file is the variable's name without ARBITER_,
/// in lower case.
struct Key {
  std::string name; ///< "extensions_max_length"
  Env variable;
};
/// In the order of the files' documentation.
[[nodiscard]] std::span<const Key> keys();

/// What an entry gives for one key, as the text that the variable would have. Empty: what the layer
/// does without any setting, whatever an earlier entry says ("default" in the file).
struct Value {
  Env variable = Env::Profile;
  std::string text;
  std::uint32_t line = 0;
};

/// Which programs: each condition that is there must hold, by one of its patterns.
struct Match {
  std::vector<std::string> names;   ///< of the executable, without its folder
  std::vector<std::string> paths;   ///< of the executable, absolute
  std::vector<std::string> windows; ///< of the .exe, without its folder, in either case
  std::vector<std::string> hashes;  ///< XXH3 of the file, 128 bits, as 32 hexadecimal digits
};

struct Entry {
  std::string title;
  Match match;
  std::vector<Value> values;
  std::vector<std::string> sources; ///< addresses where the program's fault is documented
  std::string note;
  std::string file; ///< as it was opened
  std::uint32_t line = 0;
};

/// What a file holds. Each error is one line, "FILE:LINE:COLUMN: text"; what it speaks of is left
/// out, and the rest holds.
struct File {
  std::vector<Entry> entries;
  std::vector<std::string> errors;
};

/// Reads a file's text. Paths of profiles become absolute, from the file's folder.
/// Text that is no TOML at all gives one error and no entry.
[[nodiscard]] File parseFile(std::string_view text, const std::string &path);

/// A page of text is meant; more is a mistake.
inline constexpr std::size_t kMaxFileBytes = 1u << 20;

/// parseFile() of a regular file; one that cannot be read gives one error, "FILE: text".
[[nodiscard]] File readFile(const std::string &path);

} // namespace arbiter::defaults
