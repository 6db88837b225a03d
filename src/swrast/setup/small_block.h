#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/setup/lanes.h"
#include "swrast/setup/small.h"

/// The kernels of small.h, compiled once for each instruction set, so include it only in their
/// sources. Instruction sets must not share functions: hence the unnamed namespace, and no function
/// of the standard library.
namespace arbiter::swrast {
namespace {

/// One corner of a block's triangles: the second half of their WindowVertex.
struct SnappedCorner {
  Ints x, y, outcode;
};
/// One corner of a block's triangles: the first half of their WindowVertex, without 1/w.
struct WindowCorner {
  Floats x, y, z;
};

/// Loads 16 bytes of each of the vertices 4 q + \p v of a block, one vertex into each quarter.
inline Ints quartersOf(const char *window, const std::uint32_t *vertex, int v) {
  const auto at = [&](int quarter) {
    return window + std::size_t(vertex[4 * quarter + v]) * sizeof(WindowVertex);
  };
#if defined(__SSE2__)
  const auto load = [&](int quarter) {
    return _mm_load_si128(reinterpret_cast<const __m128i *>(at(quarter)));
  };
#endif
#if defined(__AVX512F__)
  __m512i all = _mm512_castsi128_si512(load(0));
  all = _mm512_inserti32x4(all, load(1), 1);
  all = _mm512_inserti32x4(all, load(2), 2);
  return (Ints)_mm512_inserti32x4(all, load(3), 3);
#elif defined(__AVX2__)
  return (Ints)_mm256_inserti128_si256(_mm256_castsi128_si256(load(0)), load(1), 1);
#elif defined(__SSE2__)
  return (Ints)load(0);
#else
  Ints all;
  __builtin_memcpy(&all, at(0), sizeof all);
  return all;
#endif
}

/// Loads four words of each vertex of a block, one word into each vector.
inline void loadWords(const char *window, const std::uint32_t *vertex, Ints (&words)[4]) {
  for (int v = 0; v < 4; ++v)
    words[v] = quartersOf(window, vertex, v);
  turn(words[0], words[1], words[2], words[3]);
}

inline SnappedCorner snappedCorner(const WindowVertex *window, const std::uint32_t *vertex) {
  static_assert(sizeof(WindowVertex) == 32 && offsetof(WindowVertex, fixedX) == 16);
  Ints words[4];
  loadWords(reinterpret_cast<const char *>(window) + 16, vertex, words);
  return {words[0], words[1], words[2]};
}
inline WindowCorner windowCorner(const WindowVertex *window, const std::uint32_t *vertex) {
  Ints words[4];
  loadWords(reinterpret_cast<const char *>(window), vertex, words);
  return {(Floats)words[0], (Floats)words[1], (Floats)words[2]};
}

inline Ints lesser(const Ints &a, const Ints &b) { return chosen(a < b, a, b); }
inline Ints greater(const Ints &a, const Ints &b) { return chosen(a > b, a, b); }
inline Ints splat(bool all) { return Ints{} - (all ? 1 : 0); }
inline Floats sizeOf(const Floats &value) { return (Floats)((Ints)value & 0x7FFFFFFF); }

/// Computes setBounds() for a block of triangles.
struct BlockBounds {
  Ints left, bottom, right, top, originX, originY;
  Ints isSmall, isSeen; ///< masks: all bits of a lane are set, or none

  BlockBounds(const Rect &clip, const SnappedCorner (&v)[3]) {
    const Ints minX = lesser(lesser(v[0].x, v[1].x), v[2].x);
    const Ints maxX = greater(greater(v[0].x, v[1].x), v[2].x);
    const Ints minY = lesser(lesser(v[0].y, v[1].y), v[2].y);
    const Ints maxY = greater(greater(v[0].y, v[1].y), v[2].y);
    isSmall = (maxX - minX < kSmallExtent) & (maxY - minY < kSmallExtent);
    left = (minX + (kSubpixels - 1)) >> kSubpixelBits;
    bottom = (minY + (kSubpixels - 1)) >> kSubpixelBits;
    originX = greater(left, Ints{});
    originY = greater(bottom, Ints{});
    left = greater(left, Ints{} + clip.x);
    bottom = greater(bottom, Ints{} + clip.y);
    right = lesser((maxX >> kSubpixelBits) + 1, Ints{} + (clip.x + clip.width));
    top = lesser((maxY >> kSubpixelBits) + 1, Ints{} + (clip.y + clip.height));
    isSeen = (left < right) & (bottom < top);
  }
};

/// Computes an edge function from one corner to the next, at the block's origins.
struct BlockEdge {
  Ints a, b, c;
  BlockEdge(const Ints &fromX, const Ints &fromY, const Ints &toX, const Ints &toY,
            const BlockBounds &bounds) {
    a = fromY - toY;
    b = toX - fromX;
    c = -(a * (fromX - bounds.originX * kSubpixels) + b * (fromY - bounds.originY * kSubpixels));
    // Same rule as in edgeBetween(): a vector comparison gives -1 where it holds.
    c += ~((a > 0) | ((a == 0) & (b > 0)));
    c = c >> kSubpixelBits;
  }
};

/// Puts vertices into the hosts' order (HostOrder).
/// \param clockwise lanes whose triangles are clockwise to the host
inline void walkAsHosts(bool provokingIsFirst, const Ints &clockwise, Ints (&vertex)[3],
                        const Ints &provoking, WindowCorner (&v)[3]) {
  Ints isAt[3];
  for (int k = 0; k < 3; ++k)
    isAt[k] = vertex[k] == provoking;
  // The provoking corner is the last match, or, without a match, the default position.
  const Ints last = isAt[2] | (~(isAt[0] | isAt[1]) & splat(!provokingIsFirst));
  const Ints middle = isAt[1] & ~isAt[2];
  // The first corner in the hosts' order is the provoking one or the one after it.
  const Ints fromThird = provokingIsFirst ? last : middle;
  const Ints fromSecond = provokingIsFirst ? middle : ~(last | middle);
  const auto turn = [&](auto &first, auto &second, auto &third) {
    const auto p = first, q = second, r = third;
    first = chosen(fromThird, r, chosen(fromSecond, q, p));
    second = chosen(fromThird, p, chosen(fromSecond, r, q));
    third = chosen(fromThird, q, chosen(fromSecond, p, r));
  };
  const auto swap = [&](auto &one, auto &other) {
    const auto first = one, second = other;
    one = chosen(clockwise, second, first);
    other = chosen(clockwise, first, second);
  };
  const int other = provokingIsFirst ? 2 : 0;
  for (Floats WindowCorner::*const field : {&WindowCorner::x, &WindowCorner::y, &WindowCorner::z}) {
    turn(v[0].*field, v[1].*field, v[2].*field);
    swap(v[1].*field, v[other].*field);
  }
  turn(vertex[0], vertex[1], vertex[2]);
  swap(vertex[1], vertex[other]);
}

/// Computes makeDepthPlane() for a block. \return the lanes without a result
inline Ints makeDepths(const SmallSetUp &with, const WindowCorner (&v)[3], Floats (&depth)[4]) {
  const Floats x01 = v[0].x - v[1].x, y01 = v[0].y - v[1].y, z01 = v[0].z - v[1].z;
  const Floats x20 = v[2].x - v[0].x, y20 = v[2].y - v[0].y, z20 = v[2].z - v[0].z;
  const Floats area = x01 * y20 - x20 * y01;
  const Ints isLevel = (v[0].z == v[1].z) & (v[0].z == v[2].z);
  const Ints isNone = (area == 0) | ~(sizeOf(area) < __builtin_inff());
  const Floats none{};
  const Floats inverse = (none + 1.0f) / area;
  const Floats dx = z01 * (y20 * inverse) - (y01 * inverse) * z20;
  const Floats dy = z20 * (x01 * inverse) - (x20 * inverse) * z01;
  const Floats c = v[0].z - (dx * (v[0].x - 0.5f) + dy * (v[0].y - 0.5f));
  depth[0] = chosen(isLevel, v[0].z, c);
  depth[1] = chosen(isLevel, none, dx);
  depth[2] = chosen(isLevel, none, with.upsideDownHeight != 0 ? -dy : dy);
  depth[3] = none;
  if (with.offset) {
    const Floats slopeX = sizeOf((y01 * z20 - z01 * y20) * inverse);
    const Floats slopeY = sizeOf((z01 * x20 - x01 * z20) * inverse);
    const Floats slope = chosen(slopeX < slopeY, slopeY, slopeX);
    depth[3] = chosen(isLevel, none, slope) * with.offsetFactor + with.offsetConstant;
  }
  return isNone & ~isLevel;
}

inline Ints pairOf(const Ints &low, const Ints &high) { return (low & 0xFFFF) | high << 16; }

/// Stores 16 words of each lane in \p lanes, as consecutive triangles.
inline void storeBlock(Ints (&words)[16], unsigned lanes, SmallTriangle *to) {
  for (int i = 0; i < 16; i += 4)
    turn(words[i], words[i + 1], words[i + 2], words[i + 3]);
  for (; lanes != 0; lanes &= lanes - 1, ++to) {
    const int lane = __builtin_ctz(lanes);
    for (int i = 0; i < 4; ++i)
      __builtin_memcpy(reinterpret_cast<char *>(to) + 16 * i,
                       reinterpret_cast<const char *>(&words[4 * i + lane % 4]) + lane / 4 * 16,
                       16);
  }
}

/// Sets up the triangles of a group from \p first on, as many as there are lanes.
inline GroupSetUp setUpBlock(const SmallSetUp &with, const WindowVertex *window,
                             const TriangleGroup &group, int first, SmallTriangle *to) {
  SnappedCorner snapped[3];
  for (int k = 0; k < 3; ++k)
    snapped[k] = snappedCorner(window, group.vertex[k] + first);
  const BlockBounds bounds(with.clip, snapped);
  const Ints any = snapped[0].outcode | snapped[1].outcode | snapped[2].outcode;
  const Ints all = snapped[0].outcode & snapped[1].outcode & snapped[2].outcode;
  const int there = group.count - first;
  const unsigned lanes = there < kLanes ? (1u << there) - 1 : (1u << kLanes) - 1;

  GroupSetUp result;
  const Ints mayShow = (any != 0) ? (all & std::int32_t(kOutsideMask)) == 0 : bounds.isSeen;
  const Ints isSmall = (any == 0) & bounds.isSmall;
  result.other = lanesIn(mayShow & ~isSmall) & lanes;
  for (SnappedCorner &each : snapped) { // prevents overflow in the lanes of other triangles
    each.x &= isSmall;
    each.y &= isSmall;
  }
  // Twice the area, as in areaOf(). It fits, because the corners of a small triangle are close.
  const Ints area = (snapped[1].x - snapped[0].x) * (snapped[2].y - snapped[0].y) -
                    (snapped[2].x - snapped[0].x) * (snapped[1].y - snapped[0].y);
  const Ints counterclockwise = area > 0;
  const Ints isBack = with.frontIsClockwise ? counterclockwise : ~counterclockwise;
  const Ints isCulled = (isBack & splat(with.cullBack)) | (~isBack & splat(with.cullFront));
  result.small = lanesIn(mayShow & isSmall & (area != 0) & ~isCulled) & lanes;
  if (result.small == 0)
    return result;

  Ints vertex[3], provoking;
  for (int k = 0; k < 3; ++k)
    __builtin_memcpy(&vertex[k], group.vertex[k] + first, sizeof vertex[k]);
  __builtin_memcpy(&provoking, group.provoking + first, sizeof provoking);
  WindowCorner corner[3];
  for (int k = 0; k < 3; ++k)
    corner[k] = windowCorner(window, group.vertex[k] + first);
  const Ints clockwise = with.upsideDownHeight != 0 ? ~counterclockwise : counterclockwise;
  walkAsHosts(with.provokingIsFirst, clockwise, vertex, provoking, corner);
  Floats depth[4];
  result.depthless = lanesIn(makeDepths(with, corner, depth)) & result.small;

  const Ints secondX = chosen(counterclockwise, snapped[1].x, snapped[2].x);
  const Ints secondY = chosen(counterclockwise, snapped[1].y, snapped[2].y);
  const Ints thirdX = chosen(counterclockwise, snapped[2].x, snapped[1].x);
  const Ints thirdY = chosen(counterclockwise, snapped[2].y, snapped[1].y);
  const BlockEdge edges[3] = {{snapped[0].x, snapped[0].y, secondX, secondY, bounds},
                              {secondX, secondY, thirdX, thirdY, bounds},
                              {thirdX, thirdY, snapped[0].x, snapped[0].y, bounds}};
  Ints words[16] = {vertex[0],
                    vertex[1],
                    vertex[2],
                    (provoking << 1) - isBack,
                    pairOf(bounds.left, bounds.bottom),
                    pairOf(bounds.right, bounds.top),
                    pairOf(bounds.originX, bounds.originY),
                    pairOf(edges[0].a, edges[1].a),
                    pairOf(edges[0].b, edges[1].b),
                    edges[0].c,
                    edges[1].c,
                    edges[2].c,
                    (Ints)depth[0],
                    (Ints)depth[1],
                    (Ints)depth[2],
                    (Ints)depth[3]};
  storeBlock(words, result.small, to);
  return result;
}

inline GroupSetUp setUpGroup(const SmallSetUp &with, const WindowVertex *window,
                             const TriangleGroup &group, SmallTriangle *to) {
  GroupSetUp result;
  for (int first = 0; first < group.count; first += kLanes) {
    const GroupSetUp block = setUpBlock(with, window, group, first, to);
    to += __builtin_popcount(block.small);
    result.small |= block.small << first;
    result.other |= block.other << first;
    result.depthless |= block.depthless << first;
  }
  return result;
}

} // namespace
} // namespace arbiter::swrast
