#pragma once
#include <QString>

namespace arbiter::builder {

/// The result of merging two changed versions of a text line by line.
struct Merge {
  QString text;      ///< contains both changes; in a conflict, mine
  int conflicts = 0; ///< places that both changed differently
};

/// Merges two versions of \p base (\p mine and \p theirs) as diff3 does: lines that one side
/// changed are taken from it. Versions with more than some thousand differing lines count as one
/// changed place.
[[nodiscard]] Merge mergeTexts(const QString &base, const QString &mine, const QString &theirs);

} // namespace arbiter::builder
