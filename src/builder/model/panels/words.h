#pragma once
#include <QList>
#include <QString>
#include <string_view>

#include "fp_compiler/ir/ir.h"

namespace arbiter::builder {

/// What a word is, for lists and colours.
enum class WordKind { Opcode, Keyword, Option, Target, Binding, Panel };

/// A word of the languages, as the compiler's tables have it.
struct Word {
  WordKind kind = WordKind::Opcode;
  QString word;      ///< "MAD"
  QString signature; ///< "MAD result, a, b, c"
  QString formula;   ///< "a*b + c"; of opcodes
  QString doc;       ///< one line
  QString section;   ///< of the specification
  bool fragment = true, vertex = true;
};

[[nodiscard]] inline QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
}
[[nodiscard]] QString nameOf(WordKind kind);

/// All words of the ARB languages and of `#@` lines, made of the tables that the parser is made of.
[[nodiscard]] const QList<Word> &allWords();

/// The words that a search finds, the best first: words that begin with it, then those that have
/// it, then those whose meaning has it. All of them for an empty one.
[[nodiscard]] QList<Word> searchWords(const QString &search);

/// The language that a text's header names; fragment programs' without one.
[[nodiscard]] fp::ir::Language languageOf(const QString &text);

} // namespace arbiter::builder
