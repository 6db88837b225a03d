#pragma once
#include <QString>

namespace arbiter::builder {

/// Two changed texts of one, put together line by line.
struct Merge {
  QString text;      ///< with both changes; of a conflict, mine
  int conflicts = 0; ///< places that both changed, and not to the same
};

/// Merges what became of \p base here (\p mine) and elsewhere (\p theirs), as diff3 does: lines
/// that one side changed are taken from it. Texts of more than some thousand differing lines count
/// as one changed place.
[[nodiscard]] Merge mergeTexts(const QString &base, const QString &mine, const QString &theirs);

} // namespace arbiter::builder
