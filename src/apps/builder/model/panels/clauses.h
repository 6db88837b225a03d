#pragma once
#include <QList>
#include <QString>
#include <optional>

#include "apps/builder/model/text/edit.h"

namespace arbiter::builder {

/// A clause of a `#@` line: a word, and what follows it up to the next comma. Places are in UTF-16
/// units of the text.
struct Clause {
  QString word;  ///< "camera"
  QString value; ///< "orbit yaw 30", as written, without blanks around it
  qsizetype begin = 0, end = 0;
  qsizetype valueBegin = 0; ///< end if there is no value
  bool first = false;       ///< the first of its line
  bool alone = false;       ///< the only one of its line
};

/// Returns all clauses, in text order.
[[nodiscard]] QList<Clause> clausesOf(const QString &text);
/// Returns the first clause with that word.
[[nodiscard]] std::optional<Clause> clauseOf(const QString &text, const QString &word);

/// Sets the value of a word, where it is written, or in a new line behind the panel's last.
[[nodiscard]] Edit setClause(const QString &text, const QString &word, const QString &value);
/// Adds a new line for the word, even if it is written elsewhere.
[[nodiscard]] Edit addClause(const QString &text, const QString &word, const QString &value);
/// Removes a clause with its comma, or with its line if it is alone there.
[[nodiscard]] Edit removeClause(const QString &text, const Clause &clause);

/// Returns a file's name as a clause has it: in quotes unless it is a plain word with a dot.
[[nodiscard]] QString quotedName(const QString &name);

} // namespace arbiter::builder
