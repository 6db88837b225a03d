#include "apps/tools/advise/edit.h"

#include <algorithm>

#include "util/text/letters.h"

namespace arbiter::tools::advise {

namespace {

/// Returns the start of the blanks before \p at.
std::size_t skipBlanksBack(std::string_view text, std::size_t at) {
  while (at > 0 && isBlank(text[at - 1]))
    --at;
  return at;
}

std::size_t skipBlanks(std::string_view text, std::size_t at) {
  while (at < text.size() && isBlank(text[at]))
    ++at;
  return at;
}

/// Returns the position after the line end at \p at.
std::size_t skipLineEnd(std::string_view text, std::size_t at) {
  const bool two = text.substr(at, 2) == "\r\n";
  return std::min(text.size(), at + (two ? 2 : 1));
}

bool beginsLine(std::string_view text, std::size_t at) { return at == 0 || endsLine(text[at - 1]); }

/// Returns the line end that the text uses.
std::string_view lineEnd(std::string_view text) {
  const std::size_t first = text.find_first_of("\r\n");
  if (first == std::string_view::npos)
    return "\n";
  return text.substr(first, skipLineEnd(text, first) - first);
}

} // namespace

void sort(Edits &edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit &a, const Edit &b) {
    return a.span.begin != b.span.begin ? a.span.begin < b.span.begin : a.span.end < b.span.end;
  });
}

std::optional<std::string> applied(std::string_view text, const Edits &edits) {
  std::string result;
  std::size_t at = 0;
  for (const Edit &edit : edits) {
    if (edit.span.begin < at || edit.span.end < edit.span.begin || edit.span.end > text.size())
      return std::nullopt;
    result += text.substr(at, edit.span.begin - at);
    result += edit.text;
    at = edit.span.end;
  }
  result += text.substr(at);
  return result;
}

std::optional<std::uint32_t> before(const Edits &edits, std::uint32_t offset) {
  std::int64_t old = offset; // correct if no remaining edit lies before it
  for (const Edit &edit : edits) {
    if (old < std::int64_t(edit.span.begin))
      break;
    const auto written = std::int64_t(edit.text.size());
    if (old < std::int64_t(edit.span.begin) + written)
      return std::nullopt;
    old += std::int64_t(edit.span.end) - std::int64_t(edit.span.begin) - written;
  }
  return std::uint32_t(old);
}

fp::Span wholeStatement(std::string_view text, fp::Span statement) {
  std::size_t end = statement.end;
  // White space and comments may come before the semicolon.
  while (end < text.size() && text[end] != ';')
    end = text[end] == '#' ? std::min(text.find_first_of("\r\n", end), text.size()) : end + 1;
  end = std::min(end + 1, text.size());
  const std::size_t begin = skipBlanksBack(text, statement.begin);
  const std::size_t after = skipBlanks(text, end);
  const bool alone = beginsLine(text, begin) && (after == text.size() || endsLine(text[after]));
  if (alone)
    return {std::uint32_t(begin), std::uint32_t(skipLineEnd(text, after))};
  return {statement.begin, std::uint32_t(beginsLine(text, begin) ? after : end)};
}

Edit insertedBefore(std::string_view text, std::uint32_t begin,
                    const std::vector<std::string> &statements) {
  const std::size_t line = skipBlanksBack(text, begin);
  const bool own = beginsLine(text, line);
  const std::string indent(text.substr(line, own ? begin - line : 0));
  Edit edit{{own ? std::uint32_t(line) : begin, own ? std::uint32_t(line) : begin}, {}};
  for (const std::string &statement : statements)
    edit.text += own ? indent + statement + ";" + std::string(lineEnd(text)) : statement + "; ";
  return edit;
}

} // namespace arbiter::tools::advise
