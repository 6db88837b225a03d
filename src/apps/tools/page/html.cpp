#include "apps/tools/page/html.h"

#include <algorithm>
#include <cstdio>

namespace arbiter::tools {

namespace {

/// Returns the length of the UTF-8 sequence at the start of `text` (RFC 3629), or 0 if there is
/// none.
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80)
    return 1;
  const std::size_t length = lead >= 0xF5   ? 0
                             : lead >= 0xF0 ? 4
                             : lead >= 0xE0 ? 3
                             : lead >= 0xC2 ? 2
                                            : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool outside = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return overlong || outside ? 0 : length;
}

/// Returns the HTML entity of a special character, or "" for other characters.
std::string_view reference(char c) {
  switch (c) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  default:
    return {};
  }
}

/// Escapes text as HTML.
/// \param before, after written around an unprintable byte's code
std::string escape(std::string_view text, std::string_view before, std::string_view after) {
  std::string html;
  html.reserve(text.size());
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = sequenceLength(text);
    const bool control = (c >= 0 && c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
    if (length == 0 || control) {
      char code[8];
      std::snprintf(code, sizeof code, "\\x%02X", static_cast<unsigned char>(c));
      html += before;
      html += code;
      html += after;
    } else if (const std::string_view known = reference(c); !known.empty()) {
      html += known;
    } else {
      html += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return html;
}

} // namespace

std::string escaped(std::string_view text) { return escape(text, "<i>", "</i>"); }
std::string escapedAttribute(std::string_view text) { return escape(text, "", ""); }

std::string number(std::uint64_t value) { return std::to_string(value); }

std::string counted(std::uint64_t count, std::string_view noun) {
  return number(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string cell(const std::string &html) { return "<td>" + html + "</td>"; }
std::string numberCell(std::uint64_t value) { return "<td class=n>" + number(value) + "</td>"; }

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    const bool pair = text.substr(end, 2) == "\r\n";
    text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
  }
  return lines;
}

std::string caretIndent(std::string_view line, std::uint32_t column) {
  std::string indent;
  for (const char c : line.substr(0, std::min<std::size_t>(column - 1, line.size())))
    if ((c & 0xC0) != 0x80) // only a character's first byte takes a column
      indent += c == '\t' ? '\t' : ' ';
  return indent;
}

} // namespace arbiter::tools
