#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "fp_compiler/front/c_like/names.h"
#include "fp_compiler/front/words/other_words.h"
#include "fp_compiler/span.h"

namespace arbiter::fp::c_like {

/// Returns the assembly's form of a statement that is written as in C: "float x = 1.0;", "a = b;",
/// "void main() {". Empty if it is none.
/// \param first the statement's first word
[[nodiscard]] std::string statementHint(std::string_view text, Span first, Dialect dialect,
                                        const Vocabulary &vocabulary);

/// Returns the hint for a word that stands where an operand may stand: a name of GLSL, a call, or a
/// vector that is made as in GLSL. Empty for another word.
[[nodiscard]] std::string operandHint(std::string_view text, Span word, Dialect dialect,
                                      const Vocabulary &vocabulary);

/// Returns the hint for a statement of register combiners or texture shaders that begins with a
/// word of GLSL or C.
[[nodiscard]] std::string hintFor(std::string_view text, Span first);

/// True if the byte behind a word, besides spaces, is '('.
[[nodiscard]] bool isCall(std::string_view text, Span word);

} // namespace arbiter::fp::c_like
