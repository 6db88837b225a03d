#include "fp_compiler/front/nvparse/reader.h"

#include "fp_compiler/front/c_like/names.h"
#include "fp_compiler/front/words/numeral.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

bool Reader::atStatement(const char *expected) {
  if (at(TokenKind::Identifier))
    return true;
  unexpected(expected);
  m_tokens.next();
  return false;
}

std::string Reader::hintAt(const Token &token) const {
  if (isByteOf(token, "/"))
    return "a comment begins with # or //, or stands between /* and */";
  return token.kind == TokenKind::Identifier
             ? c_like::nameHint(text(token), c_like::Dialect::Combiners)
             : "";
}

bool Reader::parseEmpty() {
  return expect(TokenKind::OpenParen, "'('") && expect(TokenKind::CloseParen, "')'");
}

bool Reader::parseNumber(float &value) {
  const bool minus = acceptSign();
  Token number;
  if (!expectNumeral("a number", false, number))
    return false;
  const float magnitude = parseFloat(text(number)).value;
  value = minus ? -magnitude : magnitude;
  return true;
}

void Reader::limit(DiagnosticId id, Span span, std::string message, std::string hint) {
  if (m_options.policy == LimitPolicy::Enforce)
    return error(id, span, std::move(message), std::move(hint));
  warning(id, span, std::move(message), std::move(hint));
}

bool Reader::unknownWord(const char *expected, std::initializer_list<std::string_view> words) {
  return unexpected(expected, at(TokenKind::Identifier) ? didYouMean(text(m_tokens.peek()), words)
                                                        : std::string());
}

} // namespace arbiter::fp::nvparse
