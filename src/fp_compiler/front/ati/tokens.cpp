#include "fp_compiler/front/ati/tokens.h"

namespace arbiter::fp::ati {

Tokens::Tokens(std::string_view text, std::uint32_t begin)
    : m_text(text), m_lexer(text, begin, Words::Suffixes), m_ahead(m_lexer.next()),
      m_lastEnd(begin) {}

Token Tokens::next() {
  const Token token = m_ahead;
  m_ahead = m_lexer.next();
  m_lastEnd = token.span.end;
  return token;
}

bool Tokens::accept(TokenKind kind) {
  if (!at(kind))
    return false;
  next();
  return true;
}

bool Tokens::acceptWord(std::string_view word) {
  if (!atWord(word))
    return false;
  next();
  return true;
}

Token Tokens::nextNumeral() {
  const Token token = Lexer(m_text, m_ahead.span.begin).next();
  m_lexer = Lexer(m_text, token.span.end, Words::Suffixes);
  m_ahead = m_lexer.next();
  m_lastEnd = token.span.end;
  return token;
}

} // namespace arbiter::fp::ati
