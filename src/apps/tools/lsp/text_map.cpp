#include "apps/tools/lsp/text_map.h"

#include <algorithm>

namespace arbiter::tools::lsp {

namespace {

bool continues(char c) { return (std::uint8_t(c) & 0xC0) == 0x80; }

/// Returns the number of bytes of the character that begins here.
std::uint32_t bytesOf(std::string_view text, std::uint32_t at) {
  const auto lead = std::uint8_t(text[at]);
  const std::uint32_t wanted = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t bytes = 1;
  while (bytes < wanted && at + bytes < text.size() && continues(text[at + bytes]))
    ++bytes;
  return bytes;
}

/// Returns the units of a character of that many bytes. UTF-16 needs two for one beyond U+FFFF.
std::uint32_t unitsOf(std::uint32_t bytes, Encoding encoding) {
  if (encoding == Encoding::Utf8)
    return bytes;
  return bytes == 4 ? 2 : 1;
}

} // namespace

TextMap::TextMap(std::string_view text, Encoding encoding) : m_text(text), m_encoding(encoding) {
  for (std::uint32_t at = 0; at < text.size(); ++at)
    if (text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n')))
      m_begins.push_back(at + 1);
}

fp::Span TextMap::line(std::uint32_t number) const {
  fp::Span span = {m_begins[number], std::uint32_t(m_text.size())};
  if (number + 1 < m_begins.size()) {
    span.end = m_begins[number + 1] - 1;
    if (span.end > span.begin && m_text[span.end] == '\n' && m_text[span.end - 1] == '\r')
      --span.end;
  }
  return span;
}

std::uint32_t TextMap::lineOf(std::uint32_t offset) const {
  const auto after = std::upper_bound(m_begins.begin(), m_begins.end(), offset);
  return std::uint32_t(after - m_begins.begin()) - 1;
}

std::optional<std::uint32_t> TextMap::offset(const Json &position) const {
  const auto number = integerAt(position, {"line"});
  const auto character = integerAt(position, {"character"});
  if (!number || !character || *number < 0 || *character < 0)
    return std::nullopt;
  if (*number >= std::int64_t(m_begins.size()))
    return std::uint32_t(m_text.size());
  const fp::Span span = line(std::uint32_t(*number));
  std::uint32_t at = span.begin;
  std::int64_t left = *character;
  while (at < span.end) {
    const std::uint32_t bytes = bytesOf(m_text, at);
    left -= unitsOf(bytes, m_encoding);
    if (left < 0)
      break;
    at += bytes;
  }
  return at;
}

Json TextMap::position(std::uint32_t offset) const {
  offset = std::min(offset, std::uint32_t(m_text.size()));
  const std::uint32_t number = lineOf(offset);
  std::uint32_t units = 0;
  for (std::uint32_t at = m_begins[number]; at < offset;) {
    const std::uint32_t bytes = bytesOf(m_text, at);
    if (at + bytes > offset)
      break; // the offset lies within a character
    units += unitsOf(bytes, m_encoding);
    at += bytes;
  }
  return {{"line", number}, {"character", units}};
}

Json TextMap::range(fp::Span span) const {
  return {{"start", position(span.begin)}, {"end", position(span.end)}};
}

} // namespace arbiter::tools::lsp
