#pragma once
#include <functional>
#include <string>
#include <vector>

#include "util/defaults/entry.h"
#include "util/defaults/program.h"

/// Which entries are for a program, and what follows from them.
namespace arbiter::defaults {

struct Chosen {
  const Entry *entry = nullptr;
  std::string why; ///< the conditions that held: "name \"quake3.x86\""
};

/// A key, and the last entry that sets it.
struct Setting {
  const Key *key = nullptr;
  const Value *value = nullptr;
  const Entry *entry = nullptr;
  bool used = true; ///< false: the environment has the variable, which wins

  /// "FILE:LINE" of the value.
  [[nodiscard]] std::string place() const;
};

/// A program's defaults. It owns the files' entries, which the rest points to.
struct Choice {
  Program program;
  std::vector<File> files;
  std::vector<Chosen> entries;   ///< in the order of the files
  std::vector<Setting> settings; ///< in the order of keys()

  /// Null where no entry sets it.
  [[nodiscard]] const Setting *find(Env variable) const;
};

/// \param environment a variable's value; null: not set
[[nodiscard]] Choice choose(Program program, std::vector<File> files,
                            const std::function<const char *(const char *)> &environment);

/// This process's, read when it is first asked for; no file is read before. A set-user-id program
/// has none. Never destroyed.
/// \param shipped the folder that was installed with the layer, of the first call
[[nodiscard]] const Choice &ownChoice(const std::string &shipped);
/// The same where ownChoice() was called; null where it was not.
[[nodiscard]] const Choice *ownChoiceIfRead() noexcept;

} // namespace arbiter::defaults
