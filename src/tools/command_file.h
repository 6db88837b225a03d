#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/defaults/program.h"

/// Finds the executable file of a command line without running it.
namespace arbiter::tools {

struct CommandFile {
  std::vector<std::string> words; ///< the command line; beyond PATH the file is its first word
  std::string found;              ///< the file, as a shell finds it; empty: there is none
  std::string path;               ///< the same without symbolic links
  std::string problem;            ///< why it cannot be executed; empty: it can
  bool isBeyondPath = false;      ///< in a folder that PATH does not have
  /// Of a script the words of its first line behind "#!": the interpreter, and its option.
  std::vector<std::string> interpreter;
};

/// Looks the command's first word up, in PATH where it has no slash.
/// \param words not empty
/// \param further folders, for what is not in PATH
[[nodiscard]] CommandFile findCommand(std::vector<std::string> words,
                                      std::span<const std::string_view> further = {});

/// Returns the facts that identify the command's process (util/defaults/program.h). A script is
/// identified by its interpreter, unless it starts Wine.
[[nodiscard]] defaults::Facts factsOf(const CommandFile &command);

} // namespace arbiter::tools
