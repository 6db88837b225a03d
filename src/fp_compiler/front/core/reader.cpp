#include "fp_compiler/front/core/reader.h"

#include "fp_compiler/front/words/parts.h"

namespace arbiter::fp {

bool Reader::atWord(std::string_view word, int ahead) const {
  const Token &token = m_tokens.peek(ahead);
  return token.kind == TokenKind::Identifier && text(token) == word;
}

bool Reader::acceptWord(std::string_view word) {
  return atWord(word) && m_tokens.accept(TokenKind::Identifier);
}

bool Reader::isByteOf(const Token &token, std::string_view bytes) const {
  return token.kind == TokenKind::InvalidByte &&
         bytes.find(m_text[token.span.begin]) != std::string_view::npos;
}

bool Reader::atByte(char byte) const { return isByteOf(m_tokens.peek(), {&byte, 1}); }

bool Reader::acceptByte(char byte) {
  return atByte(byte) && m_tokens.accept(TokenKind::InvalidByte);
}

bool Reader::expectByte(char byte) {
  return acceptByte(byte) || unexpected((std::string("'") + byte + "'").c_str());
}

bool Reader::acceptSign() {
  const bool negative = m_tokens.accept(TokenKind::Minus);
  if (!negative)
    m_tokens.accept(TokenKind::Plus);
  return negative;
}

bool Reader::expect(TokenKind kind, const char *what, std::string hint) {
  return m_tokens.accept(kind) || unexpected(what, std::move(hint));
}

bool Reader::expectWord(const char *what, Token &word) {
  word = m_tokens.peek();
  return expect(TokenKind::Identifier, what);
}

bool Reader::expectNumeral(const char *what, bool integer, Token &numeral) {
  numeral = m_tokens.nextNumeral();
  if (numeral.kind == TokenKind::Integer || (!integer && numeral.kind == TokenKind::Float))
    return true;
  reportUnexpected(m_reporter, m_text, numeral, what);
  return false;
}

bool Reader::endStatement(const char *expected, std::string hint) {
  return m_tokens.accept(TokenKind::Semicolon) ||
         (!reportLostSemicolon(m_reporter, m_text, m_tokens.last(), m_tokens.peek(),
                               endsStatement(m_tokens.peek()), expected) &&
          unexpected(expected, std::move(hint)));
}

bool Reader::unexpected(const char *expected, std::string hint) {
  return unexpectedToken(m_tokens.peek(), expected, std::move(hint));
}

bool Reader::unexpectedToken(const Token &token, const char *expected, std::string hint) {
  if (hint.empty())
    hint = hintAt(token);
  if (isByteOf(token, ownBytes()))
    error(DiagnosticId::Syntax, token.span,
          "expected " + std::string(expected) + ", found " + describe(m_text, token),
          std::move(hint));
  else
    reportUnexpected(m_reporter, m_text, token, expected, std::move(hint));
  return false;
}

bool Reader::atStatement(const char *expected, const char *hint) {
  if (at(TokenKind::Identifier))
    return true;
  unexpected(expected, hint);
  if (!m_tokens.accept(TokenKind::Semicolon)) {
    m_tokens.next();
    recover();
  }
  return false;
}

bool Reader::mayResume() const {
  return endsStatement(m_tokens.peek()) || beginsLine(m_text, m_tokens.last(), m_tokens.peek());
}

void Reader::recover() {
  while (!at(TokenKind::EndOfText) && !mayResume()) {
    const Token token = m_tokens.next();
    if (token.kind == TokenKind::Semicolon)
      return;
    skipped(token);
  }
}

void Reader::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.error(id, span, std::move(message), std::move(hint));
}

void Reader::warning(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.warning(id, span, std::move(message), std::move(hint));
}

void Reader::redeclared(const Token &name, Span before) {
  error(DiagnosticId::RedeclaredName, name.span, quote(text(name)) + " is declared twice",
        "the first declaration is in line " + std::to_string(locate(m_text, before.begin).line));
}

} // namespace arbiter::fp
