#include "apps/tools/launch/shell_text.h"

#include <algorithm>
#include <string_view>

#include "util/text/letters.h"

namespace arbiter::tools {

namespace {

/// True if a shell takes the character as it is, wherever it stands in a word.
bool isPlain(char c) {
  constexpr std::string_view kPlain = "%+,-./:=@_";
  return isLetterOrDigit(c) || kPlain.find(c) != std::string_view::npos;
}

} // namespace

std::string shellQuoted(const std::string &text) {
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string shellLine(const std::vector<std::string> &words) {
  std::string line;
  for (const std::string &word : words) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), isPlain);
    line += (line.empty() ? "" : " ") + (plain ? word : shellQuoted(word));
  }
  return line;
}

} // namespace arbiter::tools
