#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// What the words of the languages mean, for documentation, hover and completion: the tables that
/// the parser is made of (ir/ops.def, words.def, ati/words.def,
/// nvparse/words.def), and bindings.def beside it.
namespace arbiter::fp::reference {

/// A word with its documentation.
struct Entry {
  std::string_view word;
  std::string_view section; ///< of the language's specification; may be empty
  std::string_view doc;     ///< one line
};

/// Which index follows a word of a binding.
enum class Index : std::uint8_t { None, Optional, Required };

struct Segment {
  std::string_view word;
  Index index = Index::None;
};

/// One binding without alternatives: "state.material.front.diffuse".
struct Binding {
  std::vector<Segment> segments;
  std::string_view section;
  std::string_view components; ///< what x, y, z and w hold
  std::string_view doc;

  /// "state.light[n].half"; an index that may be left out is printed.
  [[nodiscard]] std::string path() const;
};

/// Every binding of a language, in the order of the table. ATI's texts have program.* only.
[[nodiscard]] std::span<const Binding> bindings(ir::Language language);

/// The words that may stand behind those of `path` (at least one, without indexes) in a binding.
/// Each once, in the order of the table.
[[nodiscard]] std::vector<Segment> wordsBehind(ir::Language language,
                                               std::span<const std::string_view> path);
/// The binding of exactly these words, or nullptr.
[[nodiscard]] const Binding *findBinding(ir::Language language,
                                         std::span<const std::string_view> path);

/// The reserved words of an ARB language that are no opcodes.
[[nodiscard]] std::span<const Entry> keywords(ir::Language language);
/// The options of an ARB language.
[[nodiscard]] std::span<const Entry> options(ir::Language language);
/// The texture targets of fragment programs.
[[nodiscard]] std::span<const Entry> targets();

/// What an opcode computes, component by component where it names none: "a*b + c".
[[nodiscard]] std::string_view formula(ir::Opcode op);

/// The words of ATI's texts.
struct AtiOp {
  std::string_view word;
  int arguments;
  std::string_view formula;
};
[[nodiscard]] std::span<const AtiOp> atiOps();
[[nodiscard]] std::span<const Entry> atiStatements();
[[nodiscard]] std::span<const Entry> atiCoordinates();
/// Behind a destination: scales, then "sat".
[[nodiscard]] std::span<const Entry> atiDestinationModifiers();
/// Behind an argument, in the grammar's order.
[[nodiscard]] std::span<const Entry> atiArgumentModifiers();
/// A source; numbered from 0 if `count` is not 0: "r" with 6 is r0 to r5.
struct AtiSource {
  std::string_view word;
  int count;
  std::string_view doc;
};
[[nodiscard]] std::span<const AtiSource> atiSources();

/// Functions and words of nvparse's texts: of register combiners, or of texture shaders, whose
/// texts may go on with the others.
[[nodiscard]] std::span<const Entry> nvparseWords(ir::Language language);
/// Their registers, as sources of ATI's.
[[nodiscard]] std::span<const AtiSource> nvparseRegisters();

} // namespace arbiter::fp::reference
