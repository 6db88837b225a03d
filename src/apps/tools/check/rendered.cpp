#include "apps/tools/check/rendered.h"

#include <algorithm>

namespace arbiter::tools {

namespace {

constexpr std::string_view kHint = "  hint:";

Color colorOf(fp::Severity severity) {
  return severity == fp::Severity::Error     ? Color::Error
         : severity == fp::Severity::Warning ? Color::Warning
                                             : Color::Note;
}

/// Colors the first line of a diagnostic.
/// \param name length of the file name at the start, which may contain a colon
std::string paintedLine(const std::string &line, std::size_t name, const fp::Diagnostic &diagnostic,
                        const Style &style) {
  const std::string kind = std::string(fp::severityName(diagnostic.severity)) + ":";
  const std::size_t at = std::min(line.find(" " + kind, name), line.size());
  const std::size_t behind = std::min(at + 1 + kind.size(), line.size());
  return painted(line.substr(0, at), Color::Place, style) + " " +
         painted(kind, colorOf(diagnostic.severity), style) + line.substr(behind);
}

} // namespace

std::string renderedLine(std::string_view name, std::string_view text,
                         const fp::Diagnostic &diagnostic, const Style &style) {
  const std::string line = fp::renderLine(name, text, diagnostic);
  return style.color ? paintedLine(line, name.size(), diagnostic, style) : line;
}

std::string rendered(std::string_view name, std::string_view text, const fp::Diagnostic &diagnostic,
                     const Style &style) {
  std::string plain = fp::render(name, text, diagnostic);
  if (!style.color)
    return plain;
  // The text has the first line, the source line, the carets, and possibly a hint.
  std::string result;
  std::size_t begin = 0;
  for (int number = 0; begin < plain.size(); ++number) {
    const std::size_t end = std::min(plain.find('\n', begin), plain.size());
    const std::string line = plain.substr(begin, end - begin);
    if (number == 0)
      result += paintedLine(line, name.size(), diagnostic, style);
    else if (number == 2)
      result += painted(line, colorOf(diagnostic.severity), style);
    else if (number == 3 && line.starts_with(kHint))
      result += painted(kHint, Color::Note, style) + line.substr(kHint.size());
    else
      result += line;
    result += '\n';
    begin = end + 1;
  }
  return result;
}

std::string rendered(std::string_view name, std::string_view text,
                     const std::vector<fp::Diagnostic> &diagnostics, const Style &style) {
  std::string all;
  for (const fp::Diagnostic &diagnostic : diagnostics)
    all += rendered(name, text, diagnostic, style);
  return all;
}

} // namespace arbiter::tools
