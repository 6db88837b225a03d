#include "fp_compiler/diagnostic.h"

#include <algorithm>

#include "util/text/letters.h"

namespace arbiter::fp {

namespace {

/// How many bytes of the source line are shown around the caret. A program may be one line of a
/// megabyte.
constexpr std::uint32_t kShownBefore = 60;
constexpr std::uint32_t kShownAfter = 60;

/// Returns the text with one printable column for each byte.
std::string printable(std::string_view piece) {
  std::string shown(piece);
  for (char &c : shown)
    c = c == '\t' ? ' ' : c >= ' ' && c <= '~' ? c : '?';
  return shown;
}

/// Finds lines and columns in one pass over a text. Offsets must not decrease.
class LineCursor {
public:
  explicit LineCursor(std::string_view text) : m_text(text) {}

  LineColumn at(std::uint32_t offset) {
    const std::size_t end = std::min<std::size_t>(offset, m_text.size());
    if (end < m_lineBegin)
      *this = LineCursor(m_text);
    for (; m_next < end; ++m_next) {
      if (!endsLine(m_text[m_next]))
        continue;
      // CR LF ends its line after the LF. An offset at the LF is still in the line.
      if (m_text[m_next] == '\r' && m_next + 1 < m_text.size() && m_text[m_next + 1] == '\n')
        continue;
      ++m_line;
      m_lineBegin = m_next + 1;
    }
    return {m_line, std::uint32_t(end - m_lineBegin) + 1};
  }

private:
  std::string_view m_text;
  std::size_t m_next = 0; ///< the first byte that was not read
  std::size_t m_lineBegin = 0;
  std::uint32_t m_line = 1;
};

std::string headline(std::string_view file, const LineColumn &at, const Diagnostic &diagnostic) {
  std::string line(file);
  line += ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
  line += severityName(diagnostic.severity);
  line += ": " + diagnostic.message + " [" + diagnostic.id + "]";
  return line;
}

/// Returns the source line, a caret line and the hint.
std::string excerpt(std::string_view text, const Diagnostic &diagnostic) {
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
  std::string out = cutBefore ? "  ..." : "  ";
  out += printable(text.substr(begin, end - begin)) + (cutAfter ? "...\n" : "\n");
  out += std::string((cutBefore ? 5 : 2) + at - begin, ' ') + "^" +
         std::string(spanEnd > at ? spanEnd - at - 1 : 0, '~') + "\n";
  if (!diagnostic.hint.empty())
    out += "  hint: " + diagnostic.hint + "\n";
  return out;
}

} // namespace

const char *severityName(Severity severity) {
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

LineColumn locate(std::string_view text, std::uint32_t offset) {
  return LineCursor(text).at(offset);
}

std::string renderLine(std::string_view file, std::string_view text, const Diagnostic &diagnostic) {
  return headline(file, locate(text, diagnostic.span.begin), diagnostic);
}

std::string render(std::string_view file, std::string_view text, const Diagnostic &diagnostic) {
  return renderLine(file, text, diagnostic) + "\n" + excerpt(text, diagnostic);
}

std::string renderAll(std::string_view file, std::string_view text,
                      const std::vector<Diagnostic> &diagnostics) {
  LineCursor cursor(text);
  std::string all;
  for (const Diagnostic &diagnostic : diagnostics)
    all += headline(file, cursor.at(diagnostic.span.begin), diagnostic) + "\n" +
           excerpt(text, diagnostic);
  return all;
}

} // namespace arbiter::fp
