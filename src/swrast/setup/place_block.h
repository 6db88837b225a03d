#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/setup/lanes.h"
#include "swrast/setup/place.h"

/// The kernels of place.h, compiled once for each instruction set, so include it only in their
/// sources. Instruction sets must not share functions: hence the unnamed namespace, and no function
/// of the standard library.
namespace arbiter::swrast {
namespace {

/// A block of vertices: one vector for each component.
struct PlacedBlock {
  Floats x, y, z, inverseW;
  Ints fixedX, fixedY, outcode;
};

inline Ints coded(const Ints &mask, std::uint32_t code) { return mask & std::int32_t(code); }

inline Ints outcodesOf(const Floats (&clip)[4], bool depthClamp) {
  const Floats x = clip[0], y = clip[1], z = clip[2], w = clip[3];
  const Floats sum = x + y + z + w;
  const std::uint32_t near = depthClamp ? 0u : kOutNear, far = depthClamp ? 0u : kOutFar;
  return coded(x < -w, kOutLeft) | coded(x > w, kOutRight) | coded(y < -w, kOutBottom) |
         coded(y > w, kOutTop) | coded(z < -w, near) | coded(z > w, far) | coded(~(w > 0), kOutW) |
         coded(~(sum - sum == 0), kOutNan);
}

/// Computes value * scale + translate with a single rounding, as toWindow() does.
inline Floats scaled(const Floats &value, float scale, float translate) {
  const auto half = [&](const HalfFloats &values) {
    return narrowed(widened(values) * double(scale) + double(translate));
  };
  return HalfLanes::joined(half(HalfLanes::low(value)), half(HalfLanes::high(value)));
}

/// Rounds to integers, ties to even. Requires values up to 1e9.
inline Ints rounded(const Floats &value) {
#if defined(__AVX512F__)
  return (Ints)_mm512_cvtps_epi32((__m512)value);
#elif defined(__AVX2__)
  return (Ints)_mm256_cvtps_epi32((__m256)value);
#elif defined(__SSE2__)
  return (Ints)_mm_cvtps_epi32((__m128)value);
#else
  // Adding this number rounds the fraction away.
  const auto half = [](const HalfFloats &values) {
    const Doubles wide = __builtin_convertvector(values, Doubles);
    return __builtin_convertvector((Longs)(wide + 0x1.8p52), HalfInts);
  };
  return HalfLanes::joined(half(HalfLanes::low(value)), half(HalfLanes::high(value)));
#endif
}

/// Snaps to 1/256 of a pixel.
inline Ints snapped(const Floats &value) {
  const Floats fixed = (value - 0.5f) * float(kSubpixels);
  const Floats size = (Floats)((Ints)fixed & 0x7FFFFFFF);
  return rounded(chosen(size < 1e9f, fixed, Floats{}));
}

/// Places the vertices of a block as toWindow() does. Those that cannot be placed become 0.
inline void placeBlock(const Viewport &viewport, const Floats (&clip)[4], PlacedBlock &out) {
  const Ints placed = (out.outcode & std::int32_t(kOutW | kOutNan)) == 0;
  const auto finite = [&](int c) { return chosen(placed, clip[c], Floats{}); };
  const Floats one = Floats{} + 1.0f;
  const Floats inverseW = one / chosen(placed, clip[3], one);
  const auto place = [&](int c) {
    return scaled(finite(c) * inverseW, viewport.scale[c], viewport.translate[c]);
  };
  out.x = place(0);
  out.y = place(1);
  out.z = chosen(placed, place(2), Floats{});
  out.fixedX = snapped(out.x) & placed;
  out.fixedY = snapped(out.y);
  if (viewport.upsideDownHeight != 0)
    out.fixedY = (viewport.upsideDownHeight - 1) * kSubpixels - out.fixedY;
  out.fixedY &= placed;
  out.x = chosen(placed, out.x, Floats{});
  out.y = chosen(placed, out.y, Floats{});
  out.inverseW = chosen(placed, inverseW, Floats{});
}

/// Bounds that are kept for each lane, so that adding a block needs no operation across lanes.
struct LaneBounds {
  Ints outcodes = Ints{}, minX = Ints{} + INT32_MAX, minY = Ints{} + INT32_MAX,
       maxX = Ints{} + INT32_MIN, maxY = Ints{} + INT32_MIN;

  void add(const PlacedBlock &block) {
    outcodes |= block.outcode;
    minX = chosen(block.fixedX < minX, block.fixedX, minX);
    minY = chosen(block.fixedY < minY, block.fixedY, minY);
    maxX = chosen(block.fixedX > maxX, block.fixedX, maxX);
    maxY = chosen(block.fixedY > maxY, block.fixedY, maxY);
  }
  /// Adds the bounds of the first `lanes` lanes.
  void addTo(PlacedBounds &all, int lanes) const {
    for (int i = 0; i < lanes; ++i)
      all.add({std::uint32_t(outcodes[i]), minX[i], minY[i], maxX[i], maxY[i]});
  }
};

/// Loads the first `count` vertices of a block. The other lanes get a harmless position.
inline void load(const Vertices &vertices, std::uint32_t at, int count, Floats (&clip)[4]) {
  for (int c = 0; c < 4; ++c) {
    const float *const from = vertices.position[c] + at;
    if (count == kLanes) {
      __builtin_memcpy(&clip[c], from, sizeof clip[c]);
      continue;
    }
    clip[c] = Floats{} + (c == 3 ? 1.0f : 0.0f);
    for (int i = 0; i < count; ++i)
      clip[c][i] = from[i];
  }
}

inline void store(PlacedBlock &block, int count, WindowVertex *to) {
  static_assert(sizeof(WindowVertex) == 32 && offsetof(WindowVertex, fixedX) == 16);
  Ints none{};
  turn(block.x, block.y, block.z, block.inverseW);
  turn(block.fixedX, block.fixedY, block.outcode, none);
  const Floats *const front[4] = {&block.x, &block.y, &block.z, &block.inverseW};
  const Ints *const back[4] = {&block.fixedX, &block.fixedY, &block.outcode, &none};
  for (int i = 0; i < count; ++i) {
    auto *const bytes = reinterpret_cast<char *>(&to[i]);
    __builtin_memcpy(bytes, reinterpret_cast<const char *>(front[i % 4]) + i / 4 * 16, 16);
    __builtin_memcpy(bytes + 16, reinterpret_cast<const char *>(back[i % 4]) + i / 4 * 16, 16);
  }
}

/// Places one block of `count` vertices.
inline void placeSome(const Viewport &viewport, const Vertices &vertices, std::uint32_t at,
                      int count, WindowVertex *window, LaneBounds &bounds) {
  Floats clip[4];
  load(vertices, at, count, clip);
  PlacedBlock block;
  block.outcode = outcodesOf(clip, viewport.depthClamp);
  for (unsigned planes = viewport.userPlanes; planes != 0; planes &= planes - 1) {
    const auto plane = unsigned(__builtin_ctz(planes));
    for (int i = 0; i < count; ++i)
      if (!(vertices.clipDistance[plane][at + unsigned(i)] >= 0))
        block.outcode[i] |= std::int32_t(kOutUser << plane);
  }
  placeBlock(viewport, clip, block);
  bounds.add(block);
  store(block, count, window + at);
}

inline PlacedBounds placeAll(const Viewport &shared, const Vertices &vertices, std::uint32_t begin,
                             std::uint32_t end, WindowVertex *window) {
  // a copy, so that the compiler knows that stores to `window` do not change it
  const Viewport viewport = shared;
  PlacedBounds all;
  LaneBounds lanes;
  std::uint32_t at = begin;
  for (; end - at >= std::uint32_t(kLanes); at += kLanes)
    placeSome(viewport, vertices, at, kLanes, window, lanes);
  lanes.addTo(all, kLanes);
  if (at < end) {
    LaneBounds last;
    placeSome(viewport, vertices, at, int(end - at), window, last);
    last.addTo(all, int(end - at));
  }
  return all;
}

} // namespace
} // namespace arbiter::swrast
