#include "apps/scene/panel/token.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "util/text/letters.h"

namespace arbiter::scene {

namespace {

bool beginsWord(char c) { return isLetter(c) || c == '_'; }
bool isInWord(char c) { return beginsWord(c) || isDigit(c) || c == '-' || c == '.' || c == '/'; }

class Scanner {
public:
  Scanner(std::string_view text, fp::Span line)
      : m_text(text.substr(0, line.end)), m_at(line.begin) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    do {
      while (isBlank(peek()))
        ++m_at;
      tokens.push_back(next());
    } while (tokens.back().kind != TokenKind::End);
    return tokens;
  }

private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
  }

  Token make(TokenKind kind, std::size_t length) {
    Token token{
        kind, {std::uint32_t(m_at), std::uint32_t(m_at + length)}, m_text.substr(m_at, length)};
    m_at += length;
    return token;
  }

  Token next() {
    if (m_at >= m_text.size())
      return make(TokenKind::End, 0);
    switch (peek()) {
    case ',':
      return make(TokenKind::Comma, 1);
    case '=':
      return make(TokenKind::Equals, 1);
    case '[':
      return make(TokenKind::Open, 1);
    case ']':
      return make(TokenKind::Close, 1);
    case '"':
      return string();
    default:
      break;
    }
    if (peek() == '.' && peek(1) == '.')
      return make(TokenKind::Range, 2);
    const bool sign = peek() == '-' || peek() == '+';
    if (isDigit(peek(sign)) || (peek(sign) == '.' && isDigit(peek(std::size_t(sign) + 1))))
      return number();
    if (beginsWord(peek()) || (peek() == '.' && beginsWord(peek(1))))
      return make(TokenKind::Word, wordLength());
    return make(TokenKind::Unknown, 1);
  }

  [[nodiscard]] std::size_t wordLength() const {
    std::size_t length = 1;
    while (isInWord(peek(length)) && !(peek(length) == '.' && peek(length + 1) == '.'))
      ++length;
    return length;
  }

  /// Reads a number. "0..1" is a number, a range sign and a number; "2nd.png" is a word.
  Token number() {
    const char *const begin = m_text.data() + m_at + (peek() == '+');
    // Longer digits are no number, so that each byte of a line is read only a few times.
    constexpr std::ptrdiff_t kLongest = 64;
    const char *const end = m_text.data() + m_text.size();
    const char *limit = begin + std::min(end - begin, kLongest);
    for (const char *at = begin; at + 1 < limit; ++at)
      if (at[0] == '.' && at[1] == '.')
        limit = at;
    double value = 0;
    const auto read = std::from_chars(begin, limit, value);
    if (read.ec != std::errc() || !std::isfinite(value))
      return make(TokenKind::Unknown, wordLength());
    const std::size_t length = std::size_t(read.ptr - m_text.data()) - m_at;
    const char after = peek(length);
    const bool seconds = after == 's' && !isInWord(peek(length + 1));
    if (!seconds && isInWord(after) && !(after == '.' && peek(length + 1) == '.'))
      return make(isDigit(peek()) ? TokenKind::Word : TokenKind::Unknown, wordLength());
    Token token = make(TokenKind::Number, length + seconds);
    token.value = value;
    token.seconds = seconds;
    return token;
  }

  Token string() {
    const std::size_t close = m_text.find('"', m_at + 1);
    if (close == std::string_view::npos)
      return make(TokenKind::Unknown, m_text.size() - m_at);
    Token token = make(TokenKind::String, close + 1 - m_at);
    token.text = token.text.substr(1, token.text.size() - 2);
    return token;
  }

  std::string_view m_text;
  std::size_t m_at;
};

} // namespace

std::vector<Token> tokenise(std::string_view text, fp::Span line) {
  return Scanner(text, line).run();
}

std::vector<fp::Span> panelLines(std::string_view text) {
  std::vector<fp::Span> lines;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && !endsLine(text[end]))
      ++end;
    while (at < end && isBlank(text[at]))
      ++at;
    if (text.substr(at, end - at).starts_with("#@"))
      lines.push_back({std::uint32_t(at + 2), std::uint32_t(end)});
    at = end + 1;
  }
  return lines;
}

} // namespace arbiter::scene
