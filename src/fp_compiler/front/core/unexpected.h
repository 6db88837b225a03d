#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/token.h"

namespace arbiter::fp {

/// Returns a token of \p text for a message: in quotes, a byte by its number, or "the end of the
/// text".
[[nodiscard]] std::string describe(std::string_view text, const Token &token);

/// Reports a token that the grammar does not allow. If the token itself is wrong, reports that,
/// otherwise that something else was \p expected.
void reportUnexpected(Reporter &reporter, std::string_view text, const Token &token,
                      std::string_view expected, std::string hint = {});

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
