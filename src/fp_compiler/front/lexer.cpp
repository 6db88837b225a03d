#include "fp_compiler/front/lexer.h"

#include "fp_compiler/limits.h"

namespace arbiter::fp {

namespace {

enum ByteClass : std::uint8_t { kOther, kSpace, kLetter, kDigit };

// The C library's character classes depend on the locale, but the grammar does not.
constexpr std::array<ByteClass, 256> makeClasses() {
  std::array<ByteClass, 256> classes{};
  for (char c : {' ', '\t', '\n', '\r'})
    classes[std::uint8_t(c)] = kSpace;
  for (std::size_t c = 'a'; c <= 'z'; ++c)
    classes[c] = classes[c - 'a' + 'A'] = kLetter;
  for (std::size_t c = '0'; c <= '9'; ++c)
    classes[c] = kDigit;
  classes['_'] = classes['$'] = kLetter;
  return classes;
}
constexpr auto kClasses = makeClasses();

ByteClass classOf(char c) { return kClasses[std::uint8_t(c)]; }

constexpr TokenKind punctuation(char c, bool calls) {
  switch (c) {
  case '(':
    return calls ? TokenKind::OpenParen : TokenKind::InvalidByte;
  case ')':
    return calls ? TokenKind::CloseParen : TokenKind::InvalidByte;
  case '*':
    return calls ? TokenKind::Times : TokenKind::InvalidByte;
  case ',':
    return TokenKind::Comma;
  case ';':
    return TokenKind::Semicolon;
  case '[':
    return TokenKind::OpenBracket;
  case ']':
    return TokenKind::CloseBracket;
  case '{':
    return TokenKind::OpenBrace;
  case '}':
    return TokenKind::CloseBrace;
  case '=':
    return TokenKind::Equals;
  case '+':
    return TokenKind::Plus;
  case '-':
    return TokenKind::Minus;
  default:
    return TokenKind::InvalidByte;
  }
}

} // namespace

const char *name(TokenKind kind) {
  switch (kind) {
  case TokenKind::EndOfText:
    return "EndOfText";
  case TokenKind::Identifier:
    return "Identifier";
  case TokenKind::Integer:
    return "Integer";
  case TokenKind::Float:
    return "Float";
  case TokenKind::Dimension:
    return "Dimension";
  case TokenKind::Comma:
    return "Comma";
  case TokenKind::Semicolon:
    return "Semicolon";
  case TokenKind::Dot:
    return "Dot";
  case TokenKind::DotDot:
    return "DotDot";
  case TokenKind::OpenBracket:
    return "OpenBracket";
  case TokenKind::CloseBracket:
    return "CloseBracket";
  case TokenKind::OpenBrace:
    return "OpenBrace";
  case TokenKind::CloseBrace:
    return "CloseBrace";
  case TokenKind::Equals:
    return "Equals";
  case TokenKind::Plus:
    return "Plus";
  case TokenKind::Minus:
    return "Minus";
  case TokenKind::OpenParen:
    return "OpenParen";
  case TokenKind::CloseParen:
    return "CloseParen";
  case TokenKind::Times:
    return "Times";
  case TokenKind::InvalidByte:
    return "InvalidByte";
  case TokenKind::OverlongIdentifier:
    return "OverlongIdentifier";
  case TokenKind::OverlongNumeral:
    return "OverlongNumeral";
  }
  return "";
}

bool Lexer::is(std::uint32_t pos, char c) const { return pos < m_text.size() && m_text[pos] == c; }

bool Lexer::digitAt(std::uint32_t pos) const {
  return pos < m_text.size() && classOf(m_text[pos]) == kDigit;
}

void Lexer::skipDigits() {
  while (digitAt(m_pos))
    ++m_pos;
}

void Lexer::skipWhitespace() {
  while (m_pos < m_text.size()) {
    if (classOf(m_text[m_pos]) == kSpace) {
      ++m_pos;
    } else if (m_text[m_pos] == '#') {
      skipLine();
    } else if (m_words != Words::Calls || !skipCComment()) {
      return;
    }
  }
}

void Lexer::skipLine() {
  while (m_pos < m_text.size() && m_text[m_pos] != '\n' && m_text[m_pos] != '\r')
    ++m_pos;
}

/// Skips a comment of C or C++. Skips nothing if the comment has no end.
bool Lexer::skipCComment() {
  if (!is(m_pos, '/'))
    return false;
  if (is(m_pos + 1, '/')) {
    skipLine();
    return true;
  }
  const std::size_t end =
      is(m_pos + 1, '*') ? m_text.find("*/", m_pos + 2) : std::string_view::npos;
  if (end == std::string_view::npos)
    return false;
  m_pos = std::uint32_t(end) + 2;
  return true;
}

Token Lexer::finish(TokenKind kind, std::uint32_t begin) { return {kind, {begin, m_pos}}; }

Token Lexer::identifier(std::uint32_t begin) {
  while (m_pos < m_text.size() && classOf(m_text[m_pos]) >= kLetter)
    ++m_pos;
  return finish(m_pos - begin > kMaxIdentifierBytes ? TokenKind::OverlongIdentifier
                                                    : TokenKind::Identifier,
                begin);
}

Token Lexer::numeral(std::uint32_t begin) {
  skipDigits();
  if (m_pos == begin + 1 && is(m_pos, 'D') && m_text[begin] >= '1' && m_text[begin] <= '3' &&
      (m_pos + 1 == m_text.size() || classOf(m_text[m_pos + 1]) < kLetter)) {
    ++m_pos;
    return finish(TokenKind::Dimension, begin);
  }
  TokenKind kind = TokenKind::Integer;
  // "0..3" is a range, so its first dot does not belong to the number.
  if (is(m_pos, '.') && !is(m_pos + 1, '.')) {
    ++m_pos;
    skipDigits();
    kind = TokenKind::Float;
  }
  if (is(m_pos, 'e') || is(m_pos, 'E')) {
    const std::uint32_t sign = is(m_pos + 1, '+') || is(m_pos + 1, '-') ? 1 : 0;
    if (digitAt(m_pos + 1 + sign)) {
      m_pos += 1 + sign;
      skipDigits();
      kind = TokenKind::Float;
    }
  }
  return finish(m_pos - begin > kMaxNumeralBytes ? TokenKind::OverlongNumeral : kind, begin);
}

Token Lexer::next() {
  skipWhitespace();
  const std::uint32_t begin = m_pos;
  if (begin >= m_text.size())
    return {TokenKind::EndOfText, {std::uint32_t(m_text.size()), std::uint32_t(m_text.size())}};
  const char c = m_text[begin];
  const bool suffixes = m_words != Words::Identifiers;
  if (classOf(c) == kLetter || (suffixes && classOf(c) == kDigit))
    return identifier(begin);
  if (!suffixes && (classOf(c) == kDigit || (c == '.' && digitAt(begin + 1))))
    return numeral(begin);
  ++m_pos;
  if (c != '.')
    return finish(punctuation(c, m_words == Words::Calls), begin);
  if (suffixes || !is(m_pos, '.'))
    return finish(TokenKind::Dot, begin);
  ++m_pos;
  return finish(TokenKind::DotDot, begin);
}

TokenStream::TokenStream(std::string_view text, std::uint32_t begin, Words words)
    : m_text(text), m_words(words), m_lexer(text, begin, words), m_last{begin, begin} {
  lookAhead(begin);
}

void TokenStream::lookAhead(std::uint32_t from) {
  m_lexer = Lexer(m_text, from, m_words);
  for (Token &token : m_ahead)
    token = m_lexer.next();
}

Token TokenStream::next() {
  const Token token = m_ahead[0];
  m_ahead[0] = m_ahead[1];
  m_ahead[1] = m_lexer.next();
  m_last = token.span;
  return token;
}

bool TokenStream::accept(TokenKind kind) {
  if (!at(kind))
    return false;
  next();
  return true;
}

Token TokenStream::nextNumeral() {
  const Token token = Lexer(m_text, m_ahead[0].span.begin).next();
  m_last = token.span;
  lookAhead(token.span.end);
  return token;
}

} // namespace arbiter::fp
