#pragma once
#include <functional>
#include <string>
#include <vector>

#include "util/defaults/entry.h"
#include "util/defaults/program.h"

/// Selects the entries that apply to a program, and the settings that follow from them.
namespace arbiter::defaults {

struct Chosen {
  const Entry *entry = nullptr;
  std::string why; ///< the conditions that hold: "name \"quake3.x86\""
};

/// The value of a key, from the last entry that sets it.
struct Setting {
  const Key *key = nullptr;
  const Value *value = nullptr;
  const Entry *entry = nullptr;
  bool used = true; ///< false: the environment sets the variable and wins

  /// Returns "FILE:LINE" of the value.
  [[nodiscard]] std::string place() const;
};

/// A program's defaults. It owns the files' entries, which the rest points to.
struct Choice {
  Program program;
  std::vector<File> files;
  std::vector<Chosen> entries;   ///< in the order of the files
  std::vector<Setting> settings; ///< in the order of keys()

  /// Returns null if no entry sets it.
  [[nodiscard]] const Setting *find(Env variable) const;
};

/// Selects the entries and settings of a program.
/// \param environment returns a variable's value; null: not set
[[nodiscard]] Choice choose(Program program, std::vector<File> files,
                            const std::function<const char *(const char *)> &environment);

/// Returns this process's choice. The first call reads the files; none is read before. A
/// set-user-id program has no choice. The result is never destroyed.
/// \param shipped the folder that was installed with the layer; only the first call's counts
[[nodiscard]] const Choice &ownChoice(const std::string &shipped);
/// Returns the choice if ownChoice() was called before, else null.
[[nodiscard]] const Choice *ownChoiceIfRead() noexcept;

} // namespace arbiter::defaults
