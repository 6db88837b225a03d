#pragma once
#include <optional>
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

/// The program that a call of the C library's loader names.
struct GivenToLoader {
  CommandFile program;
  std::string libraryPath; ///< the value of --library-path; empty: the option is not there
};
/// Returns the program of `ld-linux.so.2 --library-path lib ./game`. Returns nothing for other
/// commands, and if the loader is given no file that exists.
[[nodiscard]] std::optional<GivenToLoader> givenToLoader(const CommandFile &command);

/// Returns the facts that identify the command's process (util/defaults/program.h). A script is
/// identified by its interpreter, unless it starts Wine.
[[nodiscard]] defaults::Facts factsOf(const CommandFile &command);

} // namespace arbiter::tools
