#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace arbiter::fp {

/// The words of a language that may begin a statement, and its suffix for saturation.
struct Vocabulary {
  std::vector<std::string_view> words;
  std::string_view saturate; ///< what clamps a result to [0,1] behind an opcode; empty: nothing
  /// How many parts, which commas divide, an instruction has; 0: any number, or it is none.
  std::function<int(std::string_view)> parts;
};

/// The parts between \p begin, behind the statement's first word, and the statement's end; 0 if
/// there is none, or if so many tokens of it tell nothing.
[[nodiscard]] int partsBehind(std::string_view text, std::uint32_t begin);

/// What a word of another language is here, as a hint: "did you mean 'MAD'?" or "DP3, RSQ and MUL
/// together do it". Empty for a word that other_words.def does not have.
/// \param parts of the statement: of several meanings those that have as many are the ones
[[nodiscard]] std::string meaningHint(std::string_view word, int parts,
                                      const Vocabulary &vocabulary);

/// The word that is nearest in its letters, and of equally near ones one that has as many parts.
[[nodiscard]] std::string spellingHint(std::string_view word, int parts,
                                       const Vocabulary &vocabulary);

/// meaningHint(), or else spellingHint().
[[nodiscard]] std::string statementHint(std::string_view word, int parts,
                                        const Vocabulary &vocabulary);

} // namespace arbiter::fp
