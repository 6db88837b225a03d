#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/token.h"

namespace arbiter::fp {

/// A token of \p text as messages name it: quoted, a byte by its number, or "the end of the text".
[[nodiscard]] std::string describe(std::string_view text, const Token &token);

/// Reports a token that the grammar does not allow: what is wrong with the token itself if it is
/// none, else that something else was \p expected.
void reportUnexpected(Reporter &reporter, std::string_view text, const Token &token,
                      std::string_view expected, std::string hint = {});

/// Reports what stands behind END, if anything does: an error, or a warning of NUL bytes alone.
void reportBehindEnd(Reporter &reporter, std::string_view text, const Token &token);

} // namespace arbiter::fp
