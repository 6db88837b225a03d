#pragma once
#include <cstdint>
#include <string_view>

#include "fp_compiler/front/words/language.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp {

/// The reserved words (ARB_fragment_program 3.11.2, ARB_vertex_program 2.14.2). Every other
/// identifier is None and may name a variable.
enum class Keyword : std::uint8_t {
  None,
  Opcode,
  Address,
  Alias,
  Attrib,
  Option,
  Output,
  Param,
  Temp,
  End,
  Attributes, ///< "fragment" or "vertex": an attribute binding
  Program,
  Result,
  State,
  Texture,
};

/// The suffixes that NVIDIA's options allow after an opcode's name, besides _SAT.
struct NvSuffix {
  bool half = false;        ///< H or X: a result of 16 bits is enough
  bool full = false;        ///< R
  std::uint8_t updates = 0; ///< C or C0: 1, C1: 2: the condition code that the result sets
  bool signedSaturate = false;
};

/// A reserved word, as classify() returns it.
struct Word {
  Keyword keyword = Keyword::None;
  ir::Opcode op = ir::Opcode::Mov; ///< Keyword::Opcode
  bool saturate = false;           ///< Keyword::Opcode: written with _SAT
  NvSuffix nv = {};                ///< Keyword::Opcode, under NVIDIA's options
};

/// Returns the reserved word of \p language that an identifier is, or Keyword::None. It is
/// case-sensitive, as the grammar is. The languages reserve different words.
[[nodiscard]] Word classify(std::string_view identifier, const ArbLanguage &language);

/// True for words that can only begin a statement, and for END. The parser resumes at them after an
/// error.
[[nodiscard]] bool beginsStatement(Keyword keyword);

} // namespace arbiter::fp
