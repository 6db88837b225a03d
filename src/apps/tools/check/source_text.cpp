#include "apps/tools/check/source_text.h"

#include <algorithm>

namespace arbiter::tools {

SourceText::SourceText(std::string_view text) : m_text(text), m_lines{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool crLf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] == '\n' || (text[i] == '\r' && !crLf))
      m_lines.push_back(std::uint32_t(i) + 1);
  }
}

fp::LineColumn SourceText::at(std::uint32_t offset) const {
  const auto end = std::uint32_t(std::min<std::size_t>(offset, m_text.size()));
  const auto next = std::upper_bound(m_lines.begin(), m_lines.end(), end);
  return {std::uint32_t(next - m_lines.begin()), end - *(next - 1) + 1};
}

std::string SourceText::statement(fp::Span span, std::size_t most) const {
  std::string line;
  const std::size_t end = std::min<std::size_t>(span.end, m_text.size());
  bool comment = false;
  bool blank = false;
  for (std::size_t i = span.begin; i < end; ++i) {
    const char c = m_text[i];
    comment = c != '\n' && c != '\r' && (comment || c == '#');
    if (comment || c == ' ' || (c >= '\t' && c <= '\r')) {
      blank = true;
      continue;
    }
    if (line.size() + (blank ? 2 : 1) > most) {
      line.resize(std::min(line.size(), most - std::min<std::size_t>(most, 3)));
      return line + "...";
    }
    if (blank && !line.empty())
      line += ' ';
    blank = false;
    line += c >= ' ' && c <= '~' ? c : '?';
  }
  return line;
}

} // namespace arbiter::tools
