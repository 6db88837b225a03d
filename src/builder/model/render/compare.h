#pragma once
#include <QImage>
#include <QPoint>

namespace arbiter::builder {

/// How two pictures of one size differ, in 8-bit steps.
struct Comparison {
  bool comparable = false; ///< both are there, and of one size
  int worst = 0;           ///< of all components
  qint64 pixels = 0;       ///< that differ
  QPoint worstAt;
  QImage difference; ///< opaque; each component's distance times `gain`

  [[nodiscard]] bool equal() const { return comparable && pixels == 0; }
};

/// \param gain how much differences are brightened
[[nodiscard]] Comparison compare(const QImage &a, const QImage &b, int gain = 8);

/// The left part of A beside the right part of B. \param split in [0,1]
[[nodiscard]] QImage splitOf(const QImage &a, const QImage &b, double split);

} // namespace arbiter::builder
