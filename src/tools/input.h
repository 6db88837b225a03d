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

/// "arbiter: text" on standard error.
void complain(const std::string &text);

} // namespace arbiter::tools
