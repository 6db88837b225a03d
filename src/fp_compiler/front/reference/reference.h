#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Documents the words of the languages, for documentation, hover and completion. It uses the
/// parser's tables (ir/ops.def, words.def, ati/words.def, nvparse/words.def) and bindings.def.
namespace arbiter::fp::reference {

/// A word with its documentation.
struct Entry {
  std::string_view word;
  std::string_view section; ///< of the language's specification; may be empty
  std::string_view doc;     ///< one line
};

/// Whether a word of a binding has an index.
enum class Index : std::uint8_t { None, Optional, Required };

struct Segment {
  std::string_view word;
  Index index = Index::None;
};

/// A binding without alternatives: "state.material.front.diffuse".
struct Binding {
  std::vector<Segment> segments;
  std::string_view section;
  std::string_view components; ///< what x, y, z and w hold
  std::string_view doc;

  /// Returns a path such as "state.light[n].half". An optional index is included.
  [[nodiscard]] std::string path() const;
};

/// Returns every binding of a language, in the order of the table. ATI's texts have only program.*.
[[nodiscard]] std::span<const Binding> bindings(ir::Language language);

/// Returns the words that may follow those of `path` in a binding. `path` has at least one word and
/// no indexes. Each word is returned once, in the order of the table.
[[nodiscard]] std::vector<Segment> wordsBehind(ir::Language language,
                                               std::span<const std::string_view> path);
/// Returns the binding of exactly these words, or nullptr.
[[nodiscard]] const Binding *findBinding(ir::Language language,
                                         std::span<const std::string_view> path);

/// Returns the reserved words of an ARB language that are not opcodes.
[[nodiscard]] std::span<const Entry> keywords(ir::Language language);
/// Returns the options of an ARB language.
[[nodiscard]] std::span<const Entry> options(ir::Language language);
/// Returns the texture targets of fragment programs.
[[nodiscard]] std::span<const Entry> targets();

/// Returns what an opcode computes: "a*b + c". A formula without components holds for each.
[[nodiscard]] std::string_view formula(ir::Opcode op);

/// An instruction of ATI's texts.
struct AtiOp {
  std::string_view word;
  int arguments;
  std::string_view formula;
};
[[nodiscard]] std::span<const AtiOp> atiOps();
[[nodiscard]] std::span<const Entry> atiStatements();
[[nodiscard]] std::span<const Entry> atiCoordinates();
/// Returns the words that may follow a destination: scales, then "sat".
[[nodiscard]] std::span<const Entry> atiDestinationModifiers();
/// Returns the words that may follow an argument, in the grammar's order.
[[nodiscard]] std::span<const Entry> atiArgumentModifiers();
/// A source. If `count` is not 0 it is numbered from 0: "r" with 6 is r0 to r5.
struct AtiSource {
  std::string_view word;
  int count;
  std::string_view doc;
};
[[nodiscard]] std::span<const AtiSource> atiSources();

/// Returns the functions and words of nvparse's texts: of register combiners, or of texture
/// shaders, whose texts may include register combiners.
[[nodiscard]] std::span<const Entry> nvparseWords(ir::Language language);
/// Returns the registers of nvparse's texts, in the form of ATI's sources.
[[nodiscard]] std::span<const AtiSource> nvparseRegisters();

} // namespace arbiter::fp::reference
