#pragma once
#include <string>
#include <string_view>

#include "util/result.h"

namespace arbiter::tools {

struct FileError {
  std::string message; ///< "name: reason"
};

/// Returns the bytes of a file, or of standard input for "-". Accepts at most 64 MiB, so that the
/// compiler itself reports a program over its limit of 1 MiB.
[[nodiscard]] Result<std::string, FileError> readInput(const std::string &name);

/// Writes to a file, or to standard output for "-".
/// \returns an empty string, or "name: reason".
[[nodiscard]] std::string writeOutput(const std::string &name, std::string_view bytes);

/// Replaces the content of an existing file atomically: readers see the old or the new bytes, even
/// after an interruption. Follows symbolic links and keeps the file's mode.
/// \returns an empty string, or "name: reason".
[[nodiscard]] std::string replaceFile(const std::string &name, std::string_view bytes);

/// True if both names mean the same file, or the same path if no file exists yet. "-" equals only
/// itself.
[[nodiscard]] bool isSameFile(const std::string &a, const std::string &b);

/// Returns why a file cannot be written at a path, as "name: reason", or "". Does not create the
/// file. Reports the problem early if another process will write the file.
[[nodiscard]] std::string whyNotWritable(const std::string &path);

/// Prints "arbiter VERB: text" on standard error; "arbiter: text" before speakAs().
void complain(const std::string &text);
/// Sets the verb that complain() names, so that mixed output of several commands shows its origin.
void speakAs(const std::string &verb);

} // namespace arbiter::tools
