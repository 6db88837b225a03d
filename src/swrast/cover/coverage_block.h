#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/cover/coverage.h"

/// The kernels of coverage.h, compiled once for each instruction set, so include it only in their
/// sources. Instruction sets must not share functions: hence the unnamed namespace, and no function
/// of the standard library.
namespace arbiter::swrast {
namespace {

using Int4 = std::int32_t __attribute__((vector_size(16)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Int16 = std::int32_t __attribute__((vector_size(64)));

/// Returns a mask in which bit i is set if lane i is negative.
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

/// Sixteen lanes as two vectors of eight, for processors with eight lanes. Compilers split a wider
/// vector badly, through memory.
struct Int8Pair {
  Int8 low, high;
};
[[maybe_unused]] inline Int8Pair operator+(const Int8Pair &a, const Int8Pair &b) {
  return {a.low + b.low, a.high + b.high};
}
[[maybe_unused]] inline Int8Pair operator|(const Int8Pair &a, const Int8Pair &b) {
  return {a.low | b.low, a.high | b.high};
}
[[maybe_unused]] inline Int8Pair operator~(const Int8Pair &a) { return {~a.low, ~a.high}; }
[[maybe_unused]] inline Int8Pair &operator+=(Int8Pair &a, const Int8Pair &b) { return a = a + b; }
[[maybe_unused]] inline unsigned signs(const Int8Pair &value) {
  return signs(value.low) | signs(value.high) << 8;
}

/// Sets \p to to c + a * column + b * line; the lanes run through a block row by row.
template <int kWidth, typename Int>
void setPlane(Int &to, std::int32_t c, std::int32_t a, std::int32_t b) {
  if constexpr (requires { to.high; }) {
    constexpr int kHalf = int(sizeof to.low / sizeof(std::int32_t));
    setPlane<kWidth>(to.low, c, a, b);
    setPlane<kWidth>(to.high, c + a * (kHalf % kWidth) + b * (kHalf / kWidth), a, b);
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

/// Sets \p to to \p from with a number added to each lane.
template <typename Int> void setSum(Int &to, const Int &from, std::int32_t number) {
  if constexpr (requires { to.high; }) {
    to.low = from.low + number;
    to.high = from.high + number;
  } else {
    to = from + number;
  }
}

/// Counts the bits set in the low 16.
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

/// Packs a block's first two fields as the lower half of its word.
inline std::uint64_t wordOf(std::int32_t x, std::int32_t y) {
  return (std::uint32_t(x) & 0xFFFF) | std::uint32_t(y) << 16;
}
/// Stores a block as one word: a load of the whole would have to wait for stores of single fields.
inline void storeBlock(abi::Block &to, std::uint64_t place, unsigned mask) {
  static_assert(sizeof to == sizeof place && offsetof(abi::Block, mask) == 4);
  place |= std::uint64_t(mask) << 32;
  __builtin_memcpy(static_cast<void *>(&to), &place, sizeof place);
}

/// Finds the blocks that a small triangle covers. The edge functions are held for the pixels of one
/// block, one pixel in each lane, and moved from block to block by additions.
template <typename Int, int kWidth, int kHeight>
Cover cover(const SmallTriangle &triangle, const Rect &part, abi::Block *blocks) {
  constexpr int kLanes = kWidth * kHeight;
  static_assert(sizeof(Int) == kLanes * sizeof(std::int32_t));
  const std::int32_t firstX = part.x & -kWidth, firstY = part.y & -kHeight;
  const std::int32_t right = part.x + part.width, top = part.y + part.height;
  const std::int32_t fromX = firstX - triangle.originX, fromY = firstY - triangle.originY;
  const std::int32_t a[3] = {triangle.a[0], triangle.a[1], -(triangle.a[0] + triangle.a[1])};
  const std::int32_t b[3] = {triangle.b[0], triangle.b[1], -(triangle.b[0] + triangle.b[1])};
  Int start[3], stepX[3], stepY[3];
  for (int i = 0; i < 3; ++i) {
    setPlane<kWidth>(start[i], triangle.c[i] + a[i] * fromX + b[i] * fromY, a[i], b[i]);
    setPlane<kWidth>(stepX[i], a[i] * kWidth, 0, 0);
    setPlane<kWidth>(stepY[i], b[i] * kHeight, 0, 0);
  }
  Cover result;
  constexpr unsigned kAll = (1u << kLanes) - 1;
  for (std::int32_t y = firstY; y < top; y += kHeight) {
    Int at0 = start[0], at1 = start[1], at2 = start[2];
    for (std::int32_t x = firstX; x < right; x += kWidth) {
      const unsigned mask = signs(~(at0 | at1 | at2)) & kAll;
      // Always written, but kept only if something is covered. A branch would be mispredicted
      // often.
      storeBlock(blocks[result.blocks], wordOf(x, y), mask);
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

/// Returns a mask of columns [from, to) in every row of a block.
template <int kWidth, int kHeight> unsigned columnsMask(std::int32_t from, std::int32_t to) {
  const unsigned row =
      ((1u << (to < kWidth ? to : kWidth)) - 1) & ~((1u << (from > 0 ? from : 0)) - 1);
  unsigned mask = 0;
  for (int i = 0; i < kHeight; ++i)
    mask |= row << (i * kWidth);
  return mask;
}
/// Returns a mask of rows [from, to) of a block.
template <int kWidth, int kHeight> unsigned rowsMask(std::int32_t from, std::int32_t to) {
  const std::int32_t first = from > 0 ? from : 0, last = to < kHeight ? to : kHeight;
  return ((1u << (last * kWidth)) - 1) & ~((1u << (first * kWidth)) - 1);
}

/// Finds the blocks that a region covers, sixteen blocks of a row at a time. First it finds the
/// blocks with no pixel inside and those with all. Only the others evaluate the edge functions for
/// each pixel.
template <typename Int, int kWidth, int kHeight>
Cover coverRegion(const Region &region, abi::Block *blocks) {
  constexpr int kLanes = kWidth * kHeight, kColumns = 16, kMax = Region::kMaxEdges;
  static_assert(sizeof(Int) == kLanes * sizeof(std::int32_t));
  constexpr unsigned kAll = (1u << kLanes) - 1;
  const auto least = [](std::int32_t value) { return value < 0 ? value : 0; };
  const std::int32_t firstX = region.left & -kWidth, firstY = region.bottom & -kHeight;
  const int count = region.count;
  // the edge function at a block's first pixel, relative to the first block's
  Block16 column[kMax];
  Int pixel[kMax]; // the edge function at a pixel, relative to the block's first pixel
  std::int32_t best[kMax], worst[kMax], start[kMax];
  for (int i = 0; i < count; ++i) {
    const Region::Edge &edge = region.edges[i];
    setPlane<kColumns>(column[i], 0, edge.a * kWidth, 0);
    setPlane<kWidth>(pixel[i], 0, edge.a, edge.b);
    const std::int32_t alongX = edge.a * (kWidth - 1), alongY = edge.b * (kHeight - 1);
    worst[i] = least(alongX) + least(alongY);
    best[i] = alongX + alongY - worst[i];
    start[i] = edge.c - edge.a * (region.left - firstX) - edge.b * (region.bottom - firstY);
  }
  Cover result;
  for (std::int32_t y = firstY; y < region.top; y += kHeight) {
    const unsigned rows = rowsMask<kWidth, kHeight>(region.bottom - y, region.top - y);
    for (std::int32_t first = firstX; first < region.right; first += kColumns * kWidth) {
      const int there = int(region.right - first + kWidth - 1) / kWidth;
      const unsigned some = there < kColumns ? (1u << there) - 1 : 0xFFFF;
      unsigned none = 0, notAll = 0;
      for (int i = 0; i < count; ++i) {
        const std::int32_t at = start[i] + region.edges[i].a * (first - firstX);
        Block16 corners;
        setSum(corners, column[i], at + best[i]);
        none |= signs(corners);
        setSum(corners, column[i], at + worst[i]);
        notAll |= signs(corners);
      }
      for (unsigned rest = some & ~none; rest != 0; rest &= rest - 1) {
        const int k = __builtin_ctz(rest);
        const std::int32_t x = first + k * kWidth;
        unsigned mask = rows;
        if (notAll >> k & 1) {
          unsigned outside = 0;
          for (int i = 0; i < count; ++i) {
            Int pixels;
            setSum(pixels, pixel[i], start[i] + region.edges[i].a * (x - firstX));
            outside |= signs(pixels);
          }
          mask &= ~outside & kAll;
        }
        if (x < region.left || x + kWidth > region.right)
          mask &= columnsMask<kWidth, kHeight>(region.left - x, region.right - x);
        storeBlock(blocks[result.blocks], wordOf(x, y), mask);
        result.blocks += mask != 0 ? 1 : 0;
        result.pixels += bitsOf(mask);
      }
    }
    for (int i = 0; i < count; ++i)
      start[i] += region.edges[i].b * kHeight;
  }
  return result;
}

inline Cover coverSmallBlocks(const SmallTriangle &triangle, const Rect &part, int lanes,
                              abi::Block *blocks) {
  if (lanes == 16)
    return cover<Block16, 4, 4>(triangle, part, blocks);
  if (lanes == 8)
    return cover<Int8, 4, 2>(triangle, part, blocks);
  return cover<Int4, 2, 2>(triangle, part, blocks);
}

inline Cover coverRegionBlocks(const Region &region, int lanes, abi::Block *blocks) {
  if (lanes == 16)
    return coverRegion<Block16, 4, 4>(region, blocks);
  if (lanes == 8)
    return coverRegion<Int8, 4, 2>(region, blocks);
  return coverRegion<Int4, 2, 2>(region, blocks);
}

} // namespace
} // namespace arbiter::swrast
