#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/front/token.h"

namespace arbiter::fp::c_like {

/// Returns the hint for a token that C's expressions have and the assembly does not: an operator
/// behind an operand, or the letter of "2.0f". Empty for another one.
[[nodiscard]] std::string tokenHint(std::string_view text, const Token &token);

} // namespace arbiter::fp::c_like
