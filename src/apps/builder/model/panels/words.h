#pragma once
#include <QList>
#include <QString>
#include <string_view>

#include "fp_compiler/ir/ir.h"

namespace arbiter::builder {

/// The kind of a word, for lists and colors.
enum class WordKind { Opcode, Keyword, Option, Target, Binding, Panel };

/// A word of the languages, from the compiler's tables.
struct Word {
  WordKind kind = WordKind::Opcode;
  QString word;      ///< "MAD"
  QString signature; ///< "MAD result, a, b, c"
  QString formula;   ///< "a*b + c"; only for opcodes
  QString doc;       ///< one line
  QString section;   ///< of the specification
  bool fragment = true, vertex = true;
};

[[nodiscard]] inline QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), qsizetype(utf8.size()));
}
[[nodiscard]] QString nameOf(WordKind kind);

/// Returns all words of the ARB languages and of `#@` lines, from the tables of the parsers.
[[nodiscard]] const QList<Word> &allWords();

/// Returns the words that match a search, the best first: words that begin with it, then words that
/// contain it, then words whose meaning contains it. An empty search returns all.
[[nodiscard]] QList<Word> searchWords(const QString &search);

/// Returns the language of a text's header; the fragment program language without one.
[[nodiscard]] fp::ir::Language languageOf(const QString &text);

} // namespace arbiter::builder
