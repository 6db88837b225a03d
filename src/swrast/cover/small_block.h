#pragma once
#include <cstdint>

#include "swrast/cover/small.h"

/// The inside of small.h, compiled once for each instruction set: include it only where its
/// functions are made. Nothing in here may be shared between those, hence the nameless namespace
/// and no function of the standard library.
namespace arbiter::swrast {
namespace {

using Int4 = std::int32_t __attribute__((vector_size(16)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Int16 = std::int32_t __attribute__((vector_size(64)));

/// Bit i: lane i is negative.
[[maybe_unused]] inline unsigned signs(Int4 value) {
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
[[maybe_unused]] inline unsigned signs(const Int8 &value) {
#if defined(__AVX__)
  using Float8 = float __attribute__((vector_size(32)));
  return unsigned(__builtin_ia32_movmskps256(Float8(value)));
#else
  return signs(__builtin_shufflevector(value, value, 0, 1, 2, 3)) |
         signs(__builtin_shufflevector(value, value, 4, 5, 6, 7)) << 4;
#endif
}
[[maybe_unused]] inline unsigned signs(const Int16 &value) {
#if defined(__AVX512DQ__)
  return unsigned(__builtin_ia32_cvtd2mask512(value));
#else
  return signs(__builtin_shufflevector(value, value, 0, 1, 2, 3, 4, 5, 6, 7)) |
         signs(__builtin_shufflevector(value, value, 8, 9, 10, 11, 12, 13, 14, 15)) << 8;
#endif
}

/// Sixteen lanes on processors that have eight: compilers divide a wider vector badly, through
/// memory.
struct Int8Pair {
  Int8 low, high;
};
[[maybe_unused]] inline Int8Pair operator+(const Int8Pair &a, const Int8Pair &b) {
  return {a.low + b.low, a.high + b.high};
}
[[maybe_unused]] inline Int8Pair operator|(const Int8Pair &a, const Int8Pair &b) {
  return {a.low | b.low, a.high | b.high};
}
[[maybe_unused]] inline Int8Pair &operator+=(Int8Pair &a, const Int8Pair &b) { return a = a + b; }
[[maybe_unused]] inline unsigned signs(const Int8Pair &value) {
  return signs(value.low) | signs(value.high) << 8;
}

/// \p to: c + a * column + b * line in the lanes of a block, row by row.
template <int kWidth, typename Int>
void setPlane(Int &to, std::int32_t c, std::int32_t a, std::int32_t b) {
  if constexpr (requires { to.high; }) {
    constexpr int kLines = int(sizeof to.low / sizeof(std::int32_t)) / kWidth;
    setPlane<kWidth>(to.low, c, a, b);
    setPlane<kWidth>(to.high, c + b * kLines, a, b);
  } else {
    Int column = {}, line = {};
    for (int i = 0; i < int(sizeof to / sizeof(std::int32_t)); ++i) {
      column[i] = i % kWidth;
      line[i] = i / kWidth;
    }
    to = c + a * column + b * line;
  }
}

#if defined(__AVX2__) && !defined(__AVX512F__)
using Block16 = Int8Pair;
#else
using Block16 = Int16;
#endif

/// Bits set in the low 16.
inline unsigned bitsOf(unsigned mask) {
#if defined(__POPCNT__)
  return unsigned(__builtin_popcount(mask));
#else
  mask -= (mask >> 1) & 0x5555u;
  mask = (mask & 0x3333u) + ((mask >> 2) & 0x3333u);
  mask = (mask + (mask >> 4)) & 0x0F0Fu;
  return (mask + (mask >> 8)) & 0x1Fu;
#endif
}

/// Edge functions at the pixels of a block, one a lane, moved from block to block by sums.
template <typename Int, int kWidth, int kHeight>
SmallCover cover(const WindowVertex corner[3], bool counterclockwise, const Bounds &bounds,
                 abi::Block *blocks) {
  constexpr int kLanes = kWidth * kHeight;
  static_assert(sizeof(Int) == kLanes * sizeof(std::int32_t));
  const std::int32_t firstX = bounds.left & -kWidth, firstY = bounds.bottom & -kHeight;
  const std::int32_t originX = firstX * kSubpixels, originY = firstY * kSubpixels;
  const int second = counterclockwise ? 1 : 2;
  const int order[4] = {0, second, 3 - second, 0};
  Int start[3], stepX[3], stepY[3];
  for (int i = 0; i < 3; ++i) {
    const WindowVertex &from = corner[order[i]], &to = corner[order[i + 1]];
    const std::int32_t a = from.fixedY - to.fixedY, b = to.fixedX - from.fixedX;
    std::int32_t c = -(a * (from.fixedX - originX) + b * (from.fixedY - originY));
    if (!(a > 0 || (a == 0 && b > 0)))
      --c; // as in edgeBetween()
    setPlane<kWidth>(start[i], c >> kSubpixelBits, a, b);
    setPlane<kWidth>(stepX[i], a * kWidth, 0, 0);
    setPlane<kWidth>(stepY[i], b * kHeight, 0, 0);
  }
  SmallCover result;
  constexpr unsigned kAll = (1u << kLanes) - 1;
  for (std::int32_t y = firstY; y < bounds.top; y += kHeight) {
    Int at0 = start[0], at1 = start[1], at2 = start[2];
    for (std::int32_t x = firstX; x < bounds.right; x += kWidth) {
      const unsigned mask = ~signs(at0 | at1 | at2) & kAll;
      // Written in any case, kept if something is covered: cheaper than a branch that nothing
      // foretells.
      blocks[result.blocks] = {std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0};
      result.blocks += mask != 0 ? 1 : 0;
      result.pixels += bitsOf(mask);
      at0 += stepX[0];
      at1 += stepX[1];
      at2 += stepX[2];
    }
    for (int i = 0; i < 3; ++i)
      start[i] += stepY[i];
  }
  return result;
}

inline SmallCover coverBlocks(const WindowVertex corner[3], bool counterclockwise,
                              const Bounds &bounds, int lanes, abi::Block *blocks) {
  if (lanes == 16)
    return cover<Block16, 4, 4>(corner, counterclockwise, bounds, blocks);
  if (lanes == 8)
    return cover<Int8, 4, 2>(corner, counterclockwise, bounds, blocks);
  return cover<Int4, 2, 2>(corner, counterclockwise, bounds, blocks);
}

} // namespace
} // namespace arbiter::swrast
