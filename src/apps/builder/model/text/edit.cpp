#include "apps/builder/model/text/edit.h"

#include <algorithm>

namespace arbiter::builder {

Edit difference(const QString &before, const QString &after) {
  const qsizetype shorter = std::min(before.size(), after.size());
  qsizetype begin = 0;
  while (begin < shorter && before[begin] == after[begin])
    ++begin;
  if (begin > 0 && before[begin - 1].isHighSurrogate())
    --begin;
  qsizetype end = 0;
  while (end < shorter - begin && before[before.size() - 1 - end] == after[after.size() - 1 - end])
    ++end;
  if (end > 0 && before[before.size() - end].isLowSurrogate())
    --end;
  return {begin, before.mid(begin, before.size() - begin - end),
          after.mid(begin, after.size() - begin - end)};
}

LineColumn placeOf(const QString &text, qsizetype offset) {
  offset = std::clamp<qsizetype>(offset, 0, text.size());
  const QStringView before = QStringView(text).left(offset);
  const qsizetype lineBegin = before.lastIndexOf(u'\n') + 1;
  return {int(before.count(u'\n')) + 1, int(offset - lineBegin) + 1};
}

qsizetype offsetOf(const QString &text, qint64 line, qint64 character) {
  qsizetype begin = 0;
  for (qint64 i = 0; i < line; ++i) {
    const qsizetype next = text.indexOf(u'\n', begin);
    if (next < 0)
      return text.size();
    begin = next + 1;
  }
  qsizetype end = text.indexOf(u'\n', begin);
  if (end < 0)
    end = text.size();
  return std::min<qsizetype>(begin + std::max<qint64>(character, 0), end);
}

} // namespace arbiter::builder
