#include "util/json.h"

#include <cassert>
#include <charconv>
#include <cmath>

namespace arbiter {

namespace {

bool continues(std::string_view text, std::size_t at, unsigned char low, unsigned char high) {
  return at < text.size() && static_cast<unsigned char>(text[at]) >= low &&
         static_cast<unsigned char>(text[at]) <= high;
}

/// Returns the length of the well-formed UTF-8 sequence at the front (Unicode table 3-7), or 0.
std::size_t utf8Length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80)
    return 1;
  if (lead >= 0xC2 && lead <= 0xDF)
    return continues(text, 1, 0x80, 0xBF) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const unsigned char low = lead == 0xE0 ? 0xA0 : 0x80;
    const unsigned char high = lead == 0xED ? 0x9F : 0xBF;
    return continues(text, 1, low, high) && continues(text, 2, 0x80, 0xBF) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const unsigned char low = lead == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = lead == 0xF4 ? 0x8F : 0xBF;
    return continues(text, 1, low, high) && continues(text, 2, 0x80, 0xBF) &&
                   continues(text, 3, 0x80, 0xBF)
               ? 4
               : 0;
  }
  return 0;
}

} // namespace

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0)
      return false;
    text.remove_prefix(length);
  }
  return true;
}

void JsonWriter::appendString(std::string_view text) {
  static constexpr char kDigits[] = "0123456789abcdef";
  m_text += '"';
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t length = utf8Length(text);
    if (length == 0) {
      m_text += "\xEF\xBF\xBD";
    } else if (byte == '"' || byte == '\\') {
      m_text += '\\';
      m_text += char(byte);
    } else if (byte == '\n') {
      m_text += "\\n";
    } else if (byte == '\t') {
      m_text += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      m_text += "\\u00";
      m_text += kDigits[byte >> 4];
      m_text += kDigits[byte & 15];
    } else {
      m_text += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  m_text += '"';
}

void JsonWriter::separate() {
  if (m_afterKey) {
    m_afterKey = false;
    return;
  }
  if (m_hasItems.empty())
    return;
  if (m_hasItems.back())
    m_text += ',';
  m_hasItems.back() = true;
  m_text += '\n';
  m_text.append(2 * m_hasItems.size(), ' ');
}

JsonWriter &JsonWriter::open(char bracket) {
  separate();
  m_text += bracket;
  m_hasItems.push_back(false);
  return *this;
}

JsonWriter &JsonWriter::close(char bracket) {
  assert(!m_hasItems.empty() && !m_afterKey);
  const bool hadItems = m_hasItems.back();
  m_hasItems.pop_back();
  if (hadItems) {
    m_text += '\n';
    m_text.append(2 * m_hasItems.size(), ' ');
  }
  m_text += bracket;
  return *this;
}

JsonWriter &JsonWriter::key(std::string_view name) {
  assert(!m_hasItems.empty() && !m_afterKey);
  separate();
  appendString(name);
  m_text += ": ";
  m_afterKey = true;
  return *this;
}

JsonWriter &JsonWriter::value(std::string_view text) {
  separate();
  appendString(text);
  return *this;
}

JsonWriter &JsonWriter::raw(std::string_view json) {
  separate();
  m_text += json;
  return *this;
}

JsonWriter &JsonWriter::value(bool truth) {
  separate();
  m_text += truth ? "true" : "false";
  return *this;
}

JsonWriter &JsonWriter::value(double number) {
  if (!std::isfinite(number))
    return null();
  separate();
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, number);
  m_text.append(digits, end.ptr);
  return *this;
}

JsonWriter &JsonWriter::value(std::int64_t number) {
  separate();
  m_text += std::to_string(number);
  return *this;
}

JsonWriter &JsonWriter::value(std::uint64_t number) {
  separate();
  m_text += std::to_string(number);
  return *this;
}

JsonWriter &JsonWriter::null() {
  separate();
  m_text += "null";
  return *this;
}

std::string JsonWriter::take() {
  assert(m_hasItems.empty() && !m_afterKey);
  m_text += '\n';
  return std::move(m_text);
}

} // namespace arbiter
