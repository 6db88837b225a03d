#pragma once
#include <string>
#include <vector>

/// Writes words as a POSIX shell reads them.
namespace arbiter::tools {

/// Quotes a text: 'text', with each ' written as '\''.
[[nodiscard]] std::string shellQuoted(const std::string &text);

/// Returns the words as a command line to type. Only words that a shell would change are quoted.
[[nodiscard]] std::string shellLine(const std::vector<std::string> &words);

} // namespace arbiter::tools
