#include "fp_compiler/front/nvparse/reader.h"

#include "fp_compiler/front/c_like/names.h"
#include "fp_compiler/front/unexpected.h"
#include "fp_compiler/front/words/numeral.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

bool Reader::expect(TokenKind kind, const char *what, std::string hint) {
  return m_tokens.accept(kind) || unexpected(what, std::move(hint));
}

bool Reader::endStatement(const char *expected) {
  return m_tokens.accept(TokenKind::Semicolon) ||
         (!reportLostSemicolon(m_reporter, m_text, m_tokens.last(), m_tokens.peek(),
                               m_tokens.at(TokenKind::CloseBrace), expected) &&
          unexpected(expected));
}

bool Reader::unexpected(const char *expected, std::string hint) {
  const Token &token = m_tokens.peek();
  if (hint.empty() && token.kind == TokenKind::InvalidByte && m_text[token.span.begin] == '/')
    hint = "a comment begins with # or //, or stands between /* and */";
  if (hint.empty() && token.kind == TokenKind::Identifier)
    hint = c_like::nameHint(text(token), c_like::Dialect::Combiners);
  reportUnexpected(m_reporter, m_text, token, expected, std::move(hint));
  return false;
}

bool Reader::parseEmpty() {
  return expect(TokenKind::OpenParen, "'('") && expect(TokenKind::CloseParen, "')'");
}

bool Reader::parseNumber(float &value) {
  const bool minus = m_tokens.accept(TokenKind::Minus);
  if (!minus)
    m_tokens.accept(TokenKind::Plus);
  const Token number = m_tokens.nextNumeral();
  if (number.kind != TokenKind::Integer && number.kind != TokenKind::Float) {
    reportUnexpected(m_reporter, m_text, number, "a number");
    return false;
  }
  const float magnitude = parseFloat(text(number)).value;
  value = minus ? -magnitude : magnitude;
  return true;
}

void Reader::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.error(id, span, std::move(message), std::move(hint));
}

void Reader::warning(DiagnosticId id, Span span, std::string message, std::string hint) {
  m_reporter.warning(id, span, std::move(message), std::move(hint));
}

void Reader::limit(DiagnosticId id, Span span, std::string message, std::string hint) {
  if (m_options.policy == LimitPolicy::Enforce)
    return error(id, span, std::move(message), std::move(hint));
  warning(id, span, std::move(message), std::move(hint));
}

bool Reader::unknownWord(const char *expected, std::initializer_list<std::string_view> words) {
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(expected);
  return unexpected(expected, didYouMean(text(m_tokens.peek()), words));
}

void Reader::note(const Token &name, Access access, SymbolKind kind) {
  if (m_names)
    m_names->add(text(name), name.span, access, kind);
}

void Reader::recover() {
  while (!m_tokens.at(TokenKind::EndOfText) && !m_tokens.at(TokenKind::CloseBrace))
    if (m_tokens.next().kind == TokenKind::Semicolon)
      return;
}

} // namespace arbiter::fp::nvparse
