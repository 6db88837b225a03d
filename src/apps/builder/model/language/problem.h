#pragma once
#include <QByteArray>
#include <QJsonArray>
#include <QJsonValue>
#include <QList>
#include <QString>

namespace arbiter::builder {

enum class Severity { Error = 1, Warning = 2, Note = 3 };

/// A compiler's diagnostic of a text; places are in UTF-16 units.
struct Problem {
  Severity severity = Severity::Error;
  QString code; ///< "undeclared"
  QString message;
  QString hint; ///< advice; may be empty
  QString file; ///< empty: the text itself
  qsizetype begin = 0;
  qsizetype end = 0;
  int line = 1; ///< counted from 1, like column
  int column = 1;
};

/// Reads the protocol's Diagnostic[] about \p text. It accepts any shape: a place that cannot be
/// read becomes an empty range at the beginning of the text.
[[nodiscard]] QList<Problem> problemsOf(const QJsonArray &diagnostics, const QString &text);

/// Reads a diagnostic of the control protocol (docs/write/control.md), whose places are bytes of
/// `bytes`. It accepts any shape, as problemsOf() does.
[[nodiscard]] Problem problemOfControl(const QJsonValue &json, const QByteArray &bytes);

/// Returns the next problem after a place, or the previous one before it, and wraps around at the
/// ends. Returns -1 if there is none.
[[nodiscard]] qsizetype nextProblem(const QList<Problem> &problems, qsizetype from, bool forward);

} // namespace arbiter::builder
