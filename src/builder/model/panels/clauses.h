#pragma once
#include <QList>
#include <QString>
#include <optional>

#include "builder/model/text/edit.h"

namespace arbiter::builder {

/// One clause of a `#@` line: a word, and what follows it up to the next comma. Places are in
/// UTF-16 units of the text.
struct Clause {
  QString word;  ///< "camera"
  QString value; ///< "orbit yaw 30"; as it is written, without blanks around it
  qsizetype begin = 0, end = 0;
  qsizetype valueBegin = 0; ///< end where there is no value
  bool first = false;       ///< of its line
  bool alone = false;       ///< the only one of its line
};

/// All clauses, in text order.
[[nodiscard]] QList<Clause> clausesOf(const QString &text);
/// The first one with that word.
[[nodiscard]] std::optional<Clause> clauseOf(const QString &text, const QString &word);

/// The edit that gives a word another value, where it is said, or in a new line behind the panel's
/// last.
[[nodiscard]] Edit setClause(const QString &text, const QString &word, const QString &value);
/// A new line for it, wherever else the word is said.
[[nodiscard]] Edit addClause(const QString &text, const QString &word, const QString &value);
/// The edit that takes a clause away, with its comma, or with its line where it is alone there.
[[nodiscard]] Edit removeClause(const QString &text, const Clause &clause);

/// A file's name as a clause has it: in quotes where it is no plain word with a dot.
[[nodiscard]] QString quotedName(const QString &name);

} // namespace arbiter::builder
