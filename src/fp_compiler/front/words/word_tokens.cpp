#include "fp_compiler/front/words/word_tokens.h"

namespace arbiter::fp {

WordTokens::WordTokens(std::string_view text, std::uint32_t begin, Words words)
    : m_text(text), m_words(words), m_lexer(text, begin, words),
      m_ahead(m_lexer.next()), m_last{begin, begin} {}

Token WordTokens::next() {
  const Token token = m_ahead;
  m_ahead = m_lexer.next();
  m_last = token.span;
  return token;
}

bool WordTokens::accept(TokenKind kind) {
  if (!at(kind))
    return false;
  next();
  return true;
}

bool WordTokens::acceptWord(std::string_view word) {
  if (!atWord(word))
    return false;
  next();
  return true;
}

Token WordTokens::nextNumeral() {
  const Token token = Lexer(m_text, m_ahead.span.begin).next();
  m_lexer = Lexer(m_text, token.span.end, m_words);
  m_ahead = m_lexer.next();
  m_last = token.span;
  return token;
}

} // namespace arbiter::fp
