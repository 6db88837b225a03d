#include "fp_compiler/diagnostic.h"

#include <algorithm>

namespace arbiter::fp {

namespace {

/// A source line is shown as far as this around the caret: a program may be one line of a megabyte.
constexpr std::uint32_t kShownBefore = 60;
constexpr std::uint32_t kShownAfter = 60;

const char *nameOf(Severity severity) {
  switch (severity) {
  case Severity::Error:
    return "error";
  case Severity::Warning:
    return "warning";
  case Severity::Note:
    return "note";
  }
  return "";
}

bool endsLine(char c) { return c == '\n' || c == '\r'; }

/// One column a byte, whatever the bytes are.
std::string printable(std::string_view piece) {
  std::string shown(piece);
  for (char &c : shown)
    c = c == '\t' ? ' ' : c >= ' ' && c <= '~' ? c : '?';
  return shown;
}

} // namespace

LineColumn locate(std::string_view text, std::uint32_t offset) {
  LineColumn at;
  const std::size_t end = std::min<std::size_t>(offset, text.size());
  std::size_t lineBegin = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (!endsLine(text[i]))
      continue;
    // An offset at the LF of CR LF is still in the line that the pair ends.
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n')
      if (++i == end)
        break;
    ++at.line;
    lineBegin = i + 1;
  }
  at.column = std::uint32_t(end - lineBegin) + 1;
  return at;
}

std::string renderLine(std::string_view file, std::string_view text, const Diagnostic &diagnostic) {
  const LineColumn at = locate(text, diagnostic.span.begin);
  std::string line(file);
  line += ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
  line += nameOf(diagnostic.severity);
  line += ": " + diagnostic.message + " [" + diagnostic.id + "]";
  return line;
}

std::string render(std::string_view file, std::string_view text, const Diagnostic &diagnostic) {
  std::string out = renderLine(file, text, diagnostic) + "\n";
  const std::size_t at = std::min<std::size_t>(diagnostic.span.begin, text.size());
  std::size_t begin = at;
  while (begin > 0 && at - begin < kShownBefore && !endsLine(text[begin - 1]))
    --begin;
  std::size_t end = at;
  while (end < text.size() && end - at < kShownAfter && !endsLine(text[end]))
    ++end;
  const bool cutBefore = begin > 0 && !endsLine(text[begin - 1]);
  const bool cutAfter = end < text.size() && !endsLine(text[end]);
  const std::size_t spanEnd = std::clamp<std::size_t>(diagnostic.span.end, at, end);
  out += (cutBefore ? "  ..." : "  ") + printable(text.substr(begin, end - begin)) +
         (cutAfter ? "...\n" : "\n");
  out += std::string((cutBefore ? 5 : 2) + at - begin, ' ') + "^" +
         std::string(spanEnd > at ? spanEnd - at - 1 : 0, '~') + "\n";
  if (!diagnostic.hint.empty())
    out += "  hint: " + diagnostic.hint + "\n";
  return out;
}

} // namespace arbiter::fp
