#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/token.h"
#include "fp_compiler/front/words/parts.h"

namespace arbiter::fp {

/// Returns a token of \p text for a message: in quotes, a byte by its number, or "the end of the
/// text".
[[nodiscard]] std::string describe(std::string_view text, const Token &token);

/// Reports a token that the grammar does not allow. If the token itself is wrong, reports that,
/// otherwise that something else was \p expected.
void reportUnexpected(Reporter &reporter, std::string_view text, const Token &token,
                      std::string_view expected, std::string hint = {});

/// Returns the place of a missing part of a statement, and consumes the comma before it. Returns
/// nothing if the part is there. The place is the semicolon or comma in the part's stead, or the
/// end of the last token if the next statement begins or the text ends. \param first true for the
/// statement's first part, which has no comma before it \param begins tells whether an identifier
/// may begin a statement; after a comma on the same line
///               an identifier is the part, even if a wrong one
template <typename Begins>
[[nodiscard]] std::optional<Span> missingPart(TokenStream &tokens, std::string_view text,
                                              bool first, const Begins &begins) {
  const bool comma = !first && tokens.at(TokenKind::Comma);
  const Token next = tokens.peek(comma ? 1 : 0);
  const bool stops =
      next.kind == TokenKind::Semicolon || (next.kind == TokenKind::Comma && (first || comma));
  const std::uint32_t end = comma ? tokens.peek().span.end : tokens.lastEnd();
  const bool ends =
      next.kind == TokenKind::EndOfText || (next.kind == TokenKind::Identifier && begins(next) &&
                                            (!comma || isOnLaterLine(text, end, next.span.begin)));
  if (!stops && !ends)
    return std::nullopt;
  if (comma)
    tokens.next();
  return stops ? next.span : Span{end, end};
}

/// Reports a lost semicolon, at the end of the statement that lacks it. Returns false if \p next is
/// no sign of one.
/// \param last the statement's last token
/// \param next the token after it
/// \param begins true if \p next begins another statement or ends the block; a word on a later line
///               does too
/// \param expected what could have followed: "',' or ';'"
bool reportLostSemicolon(Reporter &reporter, std::string_view text, Span last, const Token &next,
                         bool begins, std::string_view expected = "';'");

/// Reports text after END: an error, or a warning if it is only NUL bytes.
void reportBehindEnd(Reporter &reporter, std::string_view text, const Token &token);

} // namespace arbiter::fp
