#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "swrast/setup/place.h"

/// The inside of place.h, compiled once for each instruction set: include it only where its
/// functions are made. Nothing in here may be shared between those, hence the nameless namespace
/// and no function of the standard library.
namespace arbiter::swrast {
namespace {

/// Vertices of a block: what one vector holds, as wider ones are taken apart badly.
#if defined(__AVX512F__)
constexpr int kPlaced = 16;
#elif defined(__AVX2__)
constexpr int kPlaced = 8;
#else
constexpr int kPlaced = 4;
#endif

using Floats = float __attribute__((vector_size(4 * kPlaced)));
using Ints = std::int32_t __attribute__((vector_size(4 * kPlaced)));
using HalfFloats = float __attribute__((vector_size(2 * kPlaced)));
using HalfInts = std::int32_t __attribute__((vector_size(2 * kPlaced)));
using Doubles = double __attribute__((vector_size(4 * kPlaced)));
using Longs = std::int64_t __attribute__((vector_size(4 * kPlaced)));

/// Vertices of a block, one component a vector.
struct PlacedBlock {
  Floats x, y, z, inverseW;
  Ints fixedX, fixedY, outcode;
};

template <typename Vector> Vector chosen(const Ints &mask, const Vector &yes, const Vector &no) {
  return (Vector)(((Ints)yes & mask) | ((Ints)no & ~mask));
}
inline Ints coded(const Ints &mask, std::uint32_t code) { return mask & std::int32_t(code); }

inline Ints outcodesOf(const Floats (&clip)[4], bool depthClamp) {
  const Floats x = clip[0], y = clip[1], z = clip[2], w = clip[3];
  const Floats sum = x + y + z + w;
  const std::uint32_t near = depthClamp ? 0u : kOutNear, far = depthClamp ? 0u : kOutFar;
  return coded(x < -w, kOutLeft) | coded(x > w, kOutRight) | coded(y < -w, kOutBottom) |
         coded(y > w, kOutTop) | coded(z < -w, near) | coded(z > w, far) | coded(~(w > 0), kOutW) |
         coded(~(sum - sum == 0), kOutNan);
}

/// In registers: what is stored in halves and loaded whole, or the other way, waits for the stores.
template <int... lane> struct Lanes {
  template <typename Whole> static auto low(const Whole &whole) {
    return __builtin_shufflevector(whole, whole, lane...);
  }
  template <typename Whole> static auto high(const Whole &whole) {
    return __builtin_shufflevector(whole, whole, (lane + kPlaced / 2)...);
  }
  template <typename Half> static auto joined(const Half &low, const Half &high) {
    return __builtin_shufflevector(low, high, lane..., (lane + kPlaced / 2)...);
  }
};
#if defined(__AVX512F__)
using HalfLanes = Lanes<0, 1, 2, 3, 4, 5, 6, 7>;
#elif defined(__AVX2__)
using HalfLanes = Lanes<0, 1, 2, 3>;
#else
using HalfLanes = Lanes<0, 1>;
#endif

/// One rounding of the product and the sum together, as toWindow() has it.
inline Floats scaled(const Floats &value, float scale, float translate) {
  const auto half = [&](const HalfFloats &values) {
    const Doubles wide = __builtin_convertvector(values, Doubles);
    return __builtin_convertvector(wide * double(scale) + double(translate), HalfFloats);
  };
  return HalfLanes::joined(half(HalfLanes::low(value)), half(HalfLanes::high(value)));
}

/// To whole numbers, ties to even, of what is not beyond 1e9.
inline Ints rounded(const Floats &value) {
#if defined(__AVX512F__)
  return (Ints)_mm512_cvtps_epi32((__m512)value);
#elif defined(__AVX2__)
  return (Ints)_mm256_cvtps_epi32((__m256)value);
#elif defined(__SSE2__)
  return (Ints)_mm_cvtps_epi32((__m128)value);
#else
  // A sum with so great a number has no fraction left.
  const auto half = [](const HalfFloats &values) {
    const Doubles wide = __builtin_convertvector(values, Doubles);
    return __builtin_convertvector((Longs)(wide + 0x1.8p52), HalfInts);
  };
  return HalfLanes::joined(half(HalfLanes::low(value)), half(HalfLanes::high(value)));
#endif
}

/// To 1/256 of a pixel.
inline Ints snapped(const Floats &value) {
  const Floats fixed = (value - 0.5f) * float(kSubpixels);
  const Floats size = (Floats)((Ints)fixed & 0x7FFFFFFF);
  return rounded(chosen(size < 1e9f, fixed, Floats{}));
}

/// As toWindow() says, of vertices that can be placed; 0 of the others.
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

/// Of each four lanes of two vectors those that the numbers name: 0 to 3 the first's, 4 to 7 the
/// second's.
template <int p0, int p1, int p2, int p3, typename Vector>
Vector picked(const Vector &a, const Vector &b) {
#if defined(__AVX512F__)
  constexpr auto at = [](int quarter, int lane) {
    return 4 * quarter + (lane < 4 ? lane : lane - 4 + kPlaced);
  };
  return __builtin_shufflevector(a, b, at(0, p0), at(0, p1), at(0, p2), at(0, p3), at(1, p0),
                                 at(1, p1), at(1, p2), at(1, p3), at(2, p0), at(2, p1), at(2, p2),
                                 at(2, p3), at(3, p0), at(3, p1), at(3, p2), at(3, p3));
#elif defined(__AVX2__)
  constexpr auto at = [](int quarter, int lane) {
    return 4 * quarter + (lane < 4 ? lane : lane - 4 + kPlaced);
  };
  return __builtin_shufflevector(a, b, at(0, p0), at(0, p1), at(0, p2), at(0, p3), at(1, p0),
                                 at(1, p1), at(1, p2), at(1, p3));
#else
  return __builtin_shufflevector(a, b, p0, p1, p2, p3);
#endif
}

/// Of four vectors the first, second, third and fourth of each four vertices: afterwards quarter q
/// of vector v holds all four values of vertex 4 q + v.
template <typename Vector> void turn(Vector &a, Vector &b, Vector &c, Vector &d) {
  const Vector abLow = picked<0, 4, 1, 5>(a, b), cdLow = picked<0, 4, 1, 5>(c, d);
  const Vector abHigh = picked<2, 6, 3, 7>(a, b), cdHigh = picked<2, 6, 3, 7>(c, d);
  a = picked<0, 1, 4, 5>(abLow, cdLow);
  b = picked<2, 3, 6, 7>(abLow, cdLow);
  c = picked<0, 1, 4, 5>(abHigh, cdHigh);
  d = picked<2, 3, 6, 7>(abHigh, cdHigh);
}

/// Bounds lane by lane, so that blocks are added without looking across lanes.
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
  /// Of the first `lanes`.
  void addTo(PlacedBounds &all, int lanes) const {
    for (int i = 0; i < lanes; ++i)
      all.add({std::uint32_t(outcodes[i]), minX[i], minY[i], maxX[i], maxY[i]});
  }
};

/// The first `count` vertices of a block; the others are a harmless point.
inline void load(const Vertices &vertices, std::uint32_t at, int count, Floats (&clip)[4]) {
  for (int c = 0; c < 4; ++c) {
    const float *const from = vertices.position[c] + at;
    if (count == kPlaced) {
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

/// One block of `count` vertices.
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
  const Viewport viewport = shared; // no store to the window changes it, as the compiler sees
  PlacedBounds all;
  LaneBounds lanes;
  std::uint32_t at = begin;
  for (; end - at >= std::uint32_t(kPlaced); at += kPlaced)
    placeSome(viewport, vertices, at, kPlaced, window, lanes);
  lanes.addTo(all, kPlaced);
  if (at < end) {
    LaneBounds last;
    placeSome(viewport, vertices, at, int(end - at), window, last);
    last.addTo(all, int(end - at));
  }
  return all;
}

} // namespace
} // namespace arbiter::swrast
