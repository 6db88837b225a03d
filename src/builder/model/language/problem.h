#pragma once
#include <QByteArray>
#include <QJsonArray>
#include <QJsonValue>
#include <QList>
#include <QString>

namespace arbiter::builder {

enum class Severity { Error = 1, Warning = 2, Note = 3 };

/// Something that a compiler says of a text; places in UTF-16 units.
struct Problem {
  Severity severity = Severity::Error;
  QString code; ///< "undeclared"
  QString message;
  QString hint; ///< what to do; may be empty
  QString file; ///< empty: the text itself
  qsizetype begin = 0;
  qsizetype end = 0;
  int line = 1; ///< from 1, as column
  int column = 1;
};

/// Diagnostic[] of the protocol, about \p text. Whatever its shape, nothing fails: what cannot be
/// read has an empty range at the text's begin.
[[nodiscard]] QList<Problem> problemsOf(const QJsonArray &diagnostics, const QString &text);

/// A diagnostic of the control protocol (docs/write/control.md), whose places are bytes of `bytes`.
/// It reads every shape, as problemsOf() does.
[[nodiscard]] Problem problemOfControl(const QJsonValue &json, const QByteArray &bytes);

/// The problem to go to from a place: the next one behind it, or before it, and round at the ends.
/// -1 where there is none.
[[nodiscard]] qsizetype nextProblem(const QList<Problem> &problems, qsizetype from, bool forward);

} // namespace arbiter::builder
