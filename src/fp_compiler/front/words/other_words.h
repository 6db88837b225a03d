#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/front/words/parts.h"

namespace arbiter::fp {

/// The words of a language that may begin a statement, and its suffix for saturation.
struct Vocabulary {
  std::vector<std::string_view> words;
  std::string_view saturate; ///< what clamps a result to [0,1] behind an opcode; empty: nothing
  /// How many parts, which commas divide, an instruction has; 0: any number, or it is none.
  std::function<int(std::string_view)> parts;
};

/// What a word of another language is here, as a hint: "did you mean 'MAD'?" or "DP3, RSQ and MUL
/// together do it" with an example. Empty for a word that other_words.def does not have.
/// \param parts of the statement: of several meanings those that have as many are the ones, and the
/// example has the author's names
[[nodiscard]] std::string meaningHint(std::string_view word, const PartTexts &parts,
                                      const Vocabulary &vocabulary);

/// Returns how to write a call of another language: "TEX does what texture2D does". Empty for a
/// word that other_words.def does not have.
[[nodiscard]] std::string callHint(std::string_view word, const Vocabulary &vocabulary);

/// The word that is nearest in its letters, and of equally near ones one that has as many parts.
[[nodiscard]] std::string spellingHint(std::string_view word, const PartTexts &parts,
                                       const Vocabulary &vocabulary);

/// meaningHint(), or else spellingHint().
[[nodiscard]] std::string statementHint(std::string_view word, const PartTexts &parts,
                                        const Vocabulary &vocabulary);

} // namespace arbiter::fp
