#include "fp_compiler/front/core/unexpected.h"

#include "fp_compiler/front/c_like/tokens.h"
#include "fp_compiler/front/words/parts.h"
#include "fp_compiler/limits.h"

namespace arbiter::fp {

std::string describe(std::string_view text, const Token &token) {
  if (token.kind == TokenKind::EndOfText)
    return "the end of the text";
  const auto byte = token.span.begin < text.size() ? std::uint8_t(text[token.span.begin]) : 0;
  if (token.kind == TokenKind::InvalidByte && (byte < ' ' || byte > '~')) {
    static constexpr char kHex[] = "0123456789ABCDEF";
    return std::string("0x") + kHex[byte >> 4] + kHex[byte & 15];
  }
  return quote(text.substr(token.span.begin, token.span.end - token.span.begin));
}

void reportUnexpected(Reporter &reporter, std::string_view text, const Token &token,
                      std::string_view expected, std::string hint) {
  if (hint.empty())
    hint = c_like::tokenHint(text, token);
  switch (token.kind) {
  case TokenKind::InvalidByte: {
    const char c = text[token.span.begin];
    if (hint.empty() && (c == '/' || c == '*'))
      hint = "a comment begins with #";
    reporter.error(DiagnosticId::InvalidCharacter, token.span,
                   "invalid character " + describe(text, token), std::move(hint));
    return;
  }
  case TokenKind::OverlongIdentifier:
    reporter.error(DiagnosticId::IdentifierTooLong, token.span,
                   "an identifier of more than " + std::to_string(kMaxIdentifierBytes) + " bytes");
    return;
  case TokenKind::OverlongNumeral:
    reporter.error(DiagnosticId::NumeralTooLong, token.span,
                   "a numeral of more than " + std::to_string(kMaxNumeralBytes) + " characters");
    return;
  default:
    reporter.error(DiagnosticId::Syntax, token.span,
                   "expected " + std::string(expected) + ", found " + describe(text, token),
                   std::move(hint));
  }
}

bool reportLostSemicolon(Reporter &reporter, std::string_view text, Span last, const Token &next,
                         bool begins, std::string_view expected) {
  const bool ends = begins || next.kind == TokenKind::EndOfText;
  const bool later =
      next.kind == TokenKind::Identifier && isOnLaterLine(text, last.end, next.span.begin);
  if (!ends && !later)
    return false;
  reporter.error(DiagnosticId::Syntax, {last.end, last.end},
                 "expected " + std::string(ends ? "';'" : expected) + " after " +
                     quote(text.substr(last.begin, last.end - last.begin)));
  return true;
}

void reportBehindEnd(Reporter &reporter, std::string_view text, const Token &token) {
  if (token.kind == TokenKind::EndOfText)
    return;
  const std::string_view rest = text.substr(token.span.begin);
  // Callers that pass sizeof of a literal include its terminator in the length.
  if (rest.find_first_not_of('\0') == std::string_view::npos)
    return reporter.warning(DiagnosticId::TrailingNul,
                            {token.span.begin, std::uint32_t(text.size())},
                            "the length counts a NUL byte after END");
  reporter.error(DiagnosticId::TextAfterEnd, token.span, "text after END",
                 "only comments may follow END");
}

} // namespace arbiter::fp
