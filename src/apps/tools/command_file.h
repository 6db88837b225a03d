#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/defaults/program.h"

/// Finds the executable file of a command line without running it.
namespace arbiter::tools {

struct CommandFile {
  std::vector<std::string> words; ///< the command line; if isBeyondPath, the first word is the file
  std::string found;              ///< the file, as a shell finds it; empty: none
  std::string path;               ///< `found` with symbolic links resolved
  std::string problem;            ///< why it cannot be executed; empty: it can
  bool isBeyondPath = false;      ///< true if found in a folder outside PATH
  /// The interpreter and its option in a script's "#!" line; empty for other files.
  std::vector<std::string> interpreter;
};

/// Looks up the command's first word; searches PATH if it has no slash.
/// \param words not empty
/// \param further folders to search after PATH
[[nodiscard]] CommandFile findCommand(std::vector<std::string> words,
                                      std::span<const std::string_view> further = {});

/// Returns the facts that identify the command's process (util/defaults/program.h). A script is
/// identified by its interpreter, unless it starts Wine.
[[nodiscard]] defaults::Facts factsOf(const CommandFile &command);

} // namespace arbiter::tools
