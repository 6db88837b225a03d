#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/token.h"

namespace arbiter::fp {

/// A token of \p text as messages name it: quoted, a byte by its number, or "the end of the text".
[[nodiscard]] std::string describe(std::string_view text, const Token &token);

/// Reports a token that the grammar does not allow: what is wrong with the token itself if it is
/// none, else that something else was \p expected.
void reportUnexpected(Reporter &reporter, std::string_view text, const Token &token,
                      std::string_view expected, std::string hint = {});

/// True if a line ends between two places of a text.
[[nodiscard]] bool isOnLaterLine(std::string_view text, std::uint32_t from, std::uint32_t to);

/// Where a part of a statement is missing, whose comma is then consumed; nothing if anything stands
/// there: at the semicolon or the comma that stands in its place, or behind the last token where
/// the next statement begins or the text ends. \param first it is the statement's first part, which
/// has no comma before it \param begins of an identifier: it may begin a statement. Behind a comma
/// on the same line it is the part, if a wrong one
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

/// A statement must end before \p next, and did not. Reports a semicolon that was left out, at the
/// end of the statement that lacks it; false where \p next is no sign of that.
/// \param last the statement's last token
/// \param begins \p next begins another statement, or ends the block; so does a word on a later
/// line \param expected what else could have followed: "',' or ';'"
bool reportLostSemicolon(Reporter &reporter, std::string_view text, Span last, const Token &next,
                         bool begins, std::string_view expected = "';'");

/// Reports what stands behind END, if anything does: an error, or a warning of NUL bytes alone.
void reportBehindEnd(Reporter &reporter, std::string_view text, const Token &token);

} // namespace arbiter::fp
