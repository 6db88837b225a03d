#include "swrast/small.h"

namespace arbiter::swrast {
namespace {

using Int4 = std::int32_t __attribute__((vector_size(16)));

/// Bit i: lane i is negative.
unsigned signs(Int4 value) {
#if defined(__SSE__)
  using Float4 = float __attribute__((vector_size(16)));
  return unsigned(__builtin_ia32_movmskps(Float4(value)));
#else
  unsigned result = 0;
  for (int i = 0; i < 4; ++i)
    result |= unsigned(value[i] < 0) << i;
  return result;
#endif
}

} // namespace

BlockWalker::BlockWalker(const WindowVertex corner[3], bool counterclockwise, int x, int y,
                         int blockWidth, int lanes)
    : m_vectors(lanes / 4) {
  const int second = counterclockwise ? 1 : 2;
  const int order[4] = {0, second, 3 - second, 0};
  const std::int32_t originX = x * kSubpixels, originY = y * kSubpixels;
  const bool narrow = blockWidth == 2;
  const Int4 column = narrow ? Int4{0, 1, 0, 1} : Int4{0, 1, 2, 3};
  const Int4 row = narrow ? Int4{0, 0, 1, 1} : Int4{0, 0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const WindowVertex &from = corner[order[i]], &to = corner[order[i + 1]];
    const std::int32_t a = from.fixedY - to.fixedY, b = to.fixedX - from.fixedX;
    std::int32_t c = -(a * (from.fixedX - originX) + b * (from.fixedY - originY));
    if (!(a > 0 || (a == 0 && b > 0)))
      --c;
    m_a[i] = a;
    m_b[i] = b;
    Int4 lane = (c >> kSubpixelBits) + a * column + b * row;
    for (int k = 0; k < m_vectors; ++k) {
      m_lane[i][k] = lane;
      lane += b; // of blocks four pixels wide, a vector is a row
    }
  }
}

unsigned BlockWalker::mask(int dx, int dy) const {
  std::int32_t step[3];
  for (int i = 0; i < 3; ++i)
    step[i] = m_a[i] * dx + m_b[i] * dy;
  unsigned outside = 0;
  for (int k = 0; k < m_vectors; ++k)
    outside |= signs((m_lane[0][k] + step[0]) | (m_lane[1][k] + step[1]) | (m_lane[2][k] + step[2]))
               << (4 * k);
  return ~outside & ((1u << (4 * m_vectors)) - 1);
}

} // namespace arbiter::swrast
