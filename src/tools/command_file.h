#pragma once
#include <string>
#include <vector>

#include "util/defaults/program.h"

/// The file that a command line starts, found without starting it.
namespace arbiter::tools {

struct CommandFile {
  std::vector<std::string> words; ///< the command line
  std::string found;              ///< the file, as a shell finds it; empty: there is none
  std::string path;               ///< the same without symbolic links
  std::string problem;            ///< why it cannot be executed; empty: it can
  /// Of a script the words of its first line behind "#!": the interpreter, and its option.
  std::vector<std::string> interpreter;
};

/// Looks the command's first word up, in PATH where it has no slash.
/// \param words not empty
[[nodiscard]] CommandFile findCommand(std::vector<std::string> words);

/// What the process that the command becomes will be told by (util/defaults/program.h). A script's
/// process is its interpreter's, but for those that start Wine.
[[nodiscard]] defaults::Facts factsOf(const CommandFile &command);

} // namespace arbiter::tools
