#include "apps/builder/model/text/merge.h"

#include <QList>
#include <QStringList>
#include <algorithm>
#include <vector>

namespace arbiter::builder {

namespace {

/// The limit of entries in the table of the longest common subsequence.
constexpr qsizetype kMaxTable = 4'000'000;

/// Splits into lines with their ends, so that joining them gives the text again.
QStringList linesOf(const QString &text) {
  QStringList lines;
  qsizetype begin = 0;
  while (begin < text.size()) {
    const qsizetype end = text.indexOf(u'\n', begin);
    const qsizetype next = end < 0 ? text.size() : end + 1;
    lines.append(text.mid(begin, next - begin));
    begin = next;
  }
  return lines;
}

/// Returns for each line of `base` its partner in `other`, or -1; partners are in order.
std::vector<qsizetype> partners(const QStringList &base, const QStringList &other) {
  std::vector<qsizetype> result(std::size_t(base.size()), -1);
  qsizetype begin = 0;
  const qsizetype shorter = std::min(base.size(), other.size());
  while (begin < shorter && base[begin] == other[begin]) {
    result[std::size_t(begin)] = begin;
    ++begin;
  }
  qsizetype tail = 0;
  while (tail < shorter - begin && base[base.size() - 1 - tail] == other[other.size() - 1 - tail]) {
    result[std::size_t(base.size() - 1 - tail)] = other.size() - 1 - tail;
    ++tail;
  }
  const qsizetype rows = base.size() - begin - tail, columns = other.size() - begin - tail;
  if (rows == 0 || columns == 0 || (rows + 1) * (columns + 1) > kMaxTable)
    return result;
  std::vector<int> length(std::size_t((rows + 1) * (columns + 1)), 0);
  const auto at = [&](qsizetype r, qsizetype c) -> int & {
    return length[std::size_t(r * (columns + 1) + c)];
  };
  for (qsizetype r = rows - 1; r >= 0; --r)
    for (qsizetype c = columns - 1; c >= 0; --c)
      at(r, c) = base[begin + r] == other[begin + c] ? at(r + 1, c + 1) + 1
                                                     : std::max(at(r + 1, c), at(r, c + 1));
  for (qsizetype r = 0, c = 0; r < rows && c < columns;) {
    if (base[begin + r] == other[begin + c])
      result[std::size_t(begin + r++)] = begin + c++;
    else if (at(r + 1, c) >= at(r, c + 1))
      ++r;
    else
      ++c;
  }
  return result;
}

QStringList slice(const QStringList &lines, qsizetype begin, qsizetype end) {
  return lines.mid(begin, end - begin);
}

} // namespace

Merge mergeTexts(const QString &baseText, const QString &mineText, const QString &theirsText) {
  if (theirsText == mineText || theirsText == baseText)
    return {mineText, 0};
  if (mineText == baseText)
    return {theirsText, 0};
  const QStringList base = linesOf(baseText), mine = linesOf(mineText),
                    theirs = linesOf(theirsText);
  const std::vector<qsizetype> inMine = partners(base, mine), inTheirs = partners(base, theirs);
  Merge merge;
  qsizetype b = 0, m = 0, t = 0;
  while (b < base.size() || m < mine.size() || t < theirs.size()) {
    // The next line that all three have ends this piece.
    qsizetype next = b;
    while (next < base.size() && (inMine[std::size_t(next)] < m || inTheirs[std::size_t(next)] < t))
      ++next;
    const bool atEnd = next >= base.size();
    const qsizetype mineEnd = atEnd ? mine.size() : inMine[std::size_t(next)];
    const qsizetype theirsEnd = atEnd ? theirs.size() : inTheirs[std::size_t(next)];
    const QStringList ofBase = slice(base, b, next), ofMine = slice(mine, m, mineEnd),
                      ofTheirs = slice(theirs, t, theirsEnd);
    if (ofMine == ofBase)
      merge.text += ofTheirs.join(QString());
    else {
      merge.text += ofMine.join(QString());
      if (ofTheirs != ofBase && ofTheirs != ofMine)
        ++merge.conflicts;
    }
    if (!atEnd)
      merge.text += base[next];
    b = next + 1;
    m = mineEnd + 1;
    t = theirsEnd + 1;
    if (atEnd)
      break;
  }
  return merge;
}

} // namespace arbiter::builder
