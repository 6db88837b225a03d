#pragma once
#include <QString>

namespace arbiter::builder {

/// One replacement in a text. Places and lengths are in UTF-16 units, as in QString and the
/// language server protocol.
struct Edit {
  qsizetype at = 0;
  QString removed;
  QString added;

  [[nodiscard]] bool isEmpty() const { return removed.isEmpty() && added.isEmpty(); }
  [[nodiscard]] Edit inverse() const { return {at, added, removed}; }
};

/// Returns the smallest single edit from \p before to \p after; surrogate pairs stay whole.
[[nodiscard]] Edit difference(const QString &before, const QString &after);

/// A place as people count it: both numbers start at 1, and the column is in UTF-16 units.
struct LineColumn {
  int line = 1;
  int column = 1;
};

/// Returns the line and column of an offset; an offset beyond the text is its end.
[[nodiscard]] LineColumn placeOf(const QString &text, qsizetype offset);

/// Returns the offset of a line and character, both from 0 as in the protocol. A place beyond a
/// line's end is that end; one beyond the last line is the end of the text.
[[nodiscard]] qsizetype offsetOf(const QString &text, qint64 line, qint64 character);

} // namespace arbiter::builder
