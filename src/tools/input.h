#pragma once
#include <string>
#include <string_view>

#include "util/result.h"

namespace arbiter::tools {

struct FileError {
  std::string message; ///< "name: reason"
};

/// The bytes of a file, or of standard input for "-". At most 64 MiB: a program string over the
/// compiler's own limit of 1 MiB is the compiler's to report.
[[nodiscard]] Result<std::string, FileError> readInput(const std::string &name);

/// Writes to a file, or to standard output for "-".
/// \returns an empty string, or "name: reason".
[[nodiscard]] std::string writeOutput(const std::string &name, std::string_view bytes);

/// Gives a file that exists new content in one step: who reads it meanwhile, or is interrupted, has
/// the old bytes or the new ones. The file behind a symbolic link is meant; its mode stays.
/// \returns an empty string, or "name: reason".
[[nodiscard]] std::string replaceFile(const std::string &name, std::string_view bytes);

/// Both name one file, or one path where there is none yet; "-" is only itself.
[[nodiscard]] bool isSameFile(const std::string &a, const std::string &b);

/// Why a file cannot be written there, as "name: reason", found out without making it; empty if it
/// can. For what another process writes when it is too late to say so.
[[nodiscard]] std::string whyNotWritable(const std::string &path);

/// "arbiter VERB: text" on standard error, "arbiter: text" before speakAs().
void complain(const std::string &text);
/// Names the verb that this process runs, so that the output of many commands says who spoke.
void speakAs(const std::string &verb);

} // namespace arbiter::tools
