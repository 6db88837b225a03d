#pragma once
#include <QString>

namespace arbiter::builder {

/// One replacement in a text. Places and lengths are in UTF-16 units, as QString and the language
/// server protocol count them.
struct Edit {
  qsizetype at = 0;
  QString removed;
  QString added;

  [[nodiscard]] bool isEmpty() const { return removed.isEmpty() && added.isEmpty(); }
  [[nodiscard]] Edit inverse() const { return {at, added, removed}; }
};

/// The smallest single edit that makes \p after of \p before; surrogate pairs stay whole.
[[nodiscard]] Edit difference(const QString &before, const QString &after);

/// A place as people count it: both from 1, the column in UTF-16 units.
struct LineColumn {
  int line = 1;
  int column = 1;
};

/// The line and column of an offset; offsets beyond the text are its end.
[[nodiscard]] LineColumn placeOf(const QString &text, qsizetype offset);

/// The offset of a line and character, both from 0 as the protocol counts. Beyond a line's end it
/// is that end, beyond the last line the text's.
[[nodiscard]] qsizetype offsetOf(const QString &text, qint64 line, qint64 character);

} // namespace arbiter::builder
