#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/front/diagnostic_ids.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp {

/// The ARB languages that have a word.
enum class Languages : std::uint8_t { Both, Fragment, Vertex };
[[nodiscard]] constexpr bool isOf(Languages languages, bool vertex) {
  return languages == Languages::Both || (languages == Languages::Vertex) == vertex;
}

/// The data in which the two ARB assembly languages differ. They share everything else: tokens,
/// statements, parameters, state, counts.
struct ArbLanguage {
  ir::Language language;
  std::string_view header;     ///< "!!ARBfp1.0"
  const char *name;            ///< "fragment program"
  std::string_view attributes; ///< the word that attribute bindings begin with: "fragment"
  ir::Trait foreign;           ///< the trait of the opcodes that it lacks
  DiagnosticId foreignId;      ///< a feature of the other language
  const char *foreignName;     ///< "vertex programs"
  const char *nvOptions;       ///< what an NV word belongs to, in the error that refuses it
  bool saturates;              ///< _SAT
  bool colorLetters;           ///< r, g, b and a name components
  bool addresses;              ///< ADDRESS, ARL and relative operands
};

/// Returns the row of ArbFragment or ArbVertex.
[[nodiscard]] const ArbLanguage &arbLanguage(ir::Language language);

/// Returns what to write instead of a word of the other language; empty if there is no hint.
[[nodiscard]] std::string_view foreignHint(std::string_view word, const ArbLanguage &language);

/// True for instructions that only NVIDIA's options of this language have.
[[nodiscard]] bool isNvInstruction(std::string_view word, const ArbLanguage &language);

/// Returns the words that may begin a statement, as candidates for suggestions.
[[nodiscard]] std::vector<std::string_view> statementWords(const ArbLanguage &language);

} // namespace arbiter::fp
