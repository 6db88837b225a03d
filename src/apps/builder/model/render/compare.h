#pragma once
#include <QImage>
#include <QPoint>

namespace arbiter::builder {

/// The difference between two pictures of one size, in 8-bit steps.
struct Comparison {
  bool comparable = false; ///< both pictures exist and have one size
  int worst = 0;           ///< of all components
  qint64 pixels = 0;       ///< number of pixels that differ
  QPoint worstAt;
  QImage difference; ///< opaque; each component's distance times `gain`

  [[nodiscard]] bool equal() const { return comparable && pixels == 0; }
};

/// Compares two pictures. \param gain how much differences are brightened
[[nodiscard]] Comparison compare(const QImage &a, const QImage &b, int gain = 8);

/// Returns the left part of A beside the right part of B. \param split in [0,1]
[[nodiscard]] QImage splitOf(const QImage &a, const QImage &b, double split);

} // namespace arbiter::builder
