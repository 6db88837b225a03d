#include "apps/builder/model/render/compare.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace arbiter::builder {

Comparison compare(const QImage &first, const QImage &second, int gain) {
  Comparison result;
  if (first.isNull() || first.size() != second.size())
    return result;
  result.comparable = true;
  const QImage a = first.convertToFormat(QImage::Format_RGBA8888);
  const QImage b = second.convertToFormat(QImage::Format_RGBA8888);
  result.difference = QImage(a.size(), QImage::Format_RGBA8888);
  for (int y = 0; y < a.height(); ++y) {
    const uchar *left = a.constScanLine(y), *right = b.constScanLine(y);
    uchar *out = result.difference.scanLine(y);
    for (int x = 0; x < a.width(); ++x, left += 4, right += 4, out += 4) {
      int worst = 0;
      for (int c = 0; c < 4; ++c) {
        const int distance = std::abs(int(left[c]) - int(right[c]));
        worst = std::max(worst, distance);
        if (c < 3)
          out[c] = uchar(std::min(255, distance * gain));
      }
      out[3] = 255;
      result.pixels += worst > 0;
      if (worst > result.worst) {
        result.worst = worst;
        result.worstAt = {x, y};
      }
    }
  }
  return result;
}

QImage splitOf(const QImage &a, const QImage &b, double split) {
  if (a.isNull() || b.isNull() || a.size() != b.size())
    return a.isNull() ? b : a;
  QImage out = b.convertToFormat(QImage::Format_RGBA8888);
  const QImage left = a.convertToFormat(QImage::Format_RGBA8888);
  const auto width = std::size_t(std::clamp(int(split * a.width() + 0.5), 0, a.width()));
  for (int y = 0; y < out.height(); ++y)
    std::memcpy(out.scanLine(y), left.constScanLine(y), width * 4);
  return out;
}

} // namespace arbiter::builder
