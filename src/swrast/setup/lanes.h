#pragma once
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// The widest vectors of an instruction set, with the shuffles that they need. Include it only in
/// sources that are compiled once for each instruction set. Instruction sets must not share
/// functions: hence the unnamed namespace, and no function of the standard library.
namespace arbiter::swrast {
namespace {

/// The number of 32-bit lanes in one register. Compilers split wider vectors badly.
#if defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif

using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = std::int32_t __attribute__((vector_size(4 * kLanes)));
using HalfFloats = float __attribute__((vector_size(2 * kLanes)));
using HalfInts = std::int32_t __attribute__((vector_size(2 * kLanes)));
using Doubles = double __attribute__((vector_size(4 * kLanes)));
using Longs = std::int64_t __attribute__((vector_size(4 * kLanes)));

/// Selects `yes` or `no` for each lane. \param mask all bits of a lane are set, or none
template <typename Vector> Vector chosen(const Ints &mask, const Vector &yes, const Vector &no) {
  return mask ? yes : no;
}

/// Returns a mask in which bit i is set if lane i is.
[[maybe_unused]] inline unsigned lanesIn(const Ints &mask) {
#if defined(__AVX512F__)
  return unsigned(_mm512_movepi32_mask((__m512i)mask));
#elif defined(__AVX2__)
  return unsigned(_mm256_movemask_ps((__m256)mask));
#elif defined(__SSE2__)
  return unsigned(_mm_movemask_ps((__m128)mask));
#else
  unsigned lanes = 0;
  for (int i = 0; i < kLanes; ++i)
    lanes |= unsigned(mask[i] < 0) << i;
  return lanes;
#endif
}

/// Converts to double. It uses the instruction, because compilers convert a wide vector in pieces.
/// The form with a full mask is the same instruction; GCC 12 warns of the form without one.
[[maybe_unused]] inline Doubles widened(const HalfFloats &values) {
#if defined(__AVX512F__)
  return (Doubles)_mm512_maskz_cvtps_pd(__mmask8(-1), (__m256)values);
#else
  return __builtin_convertvector(values, Doubles);
#endif
}
[[maybe_unused]] inline HalfFloats narrowed(const Doubles &values) {
#if defined(__AVX512F__)
  return (HalfFloats)_mm512_cvtpd_ps((__m512d)values);
#else
  return __builtin_convertvector(values, HalfFloats);
#endif
}

/// Splits and joins vectors in registers. Through memory, a load would wait for stores of another
/// size.
template <int... lane> struct Lanes {
  template <typename Whole> static auto low(const Whole &whole) {
    return __builtin_shufflevector(whole, whole, lane...);
  }
  template <typename Whole> static auto high(const Whole &whole) {
    return __builtin_shufflevector(whole, whole, (lane + kLanes / 2)...);
  }
  template <typename Half> static auto joined(const Half &low, const Half &high) {
    return __builtin_shufflevector(low, high, lane..., (lane + kLanes / 2)...);
  }
};
#if defined(__AVX512F__)
using HalfLanes = Lanes<0, 1, 2, 3, 4, 5, 6, 7>;
#elif defined(__AVX2__)
using HalfLanes = Lanes<0, 1, 2, 3>;
#else
using HalfLanes = Lanes<0, 1>;
#endif

/// Selects from each four lanes of two vectors: numbers 0 to 3 are lanes of `a`, 4 to 7 lanes of
/// `b`.
template <int p0, int p1, int p2, int p3, typename Vector>
Vector picked(const Vector &a, const Vector &b) {
#if defined(__AVX512F__)
  constexpr auto at = [](int quarter, int lane) {
    return 4 * quarter + (lane < 4 ? lane : lane - 4 + kLanes);
  };
  return __builtin_shufflevector(a, b, at(0, p0), at(0, p1), at(0, p2), at(0, p3), at(1, p0),
                                 at(1, p1), at(1, p2), at(1, p3), at(2, p0), at(2, p1), at(2, p2),
                                 at(2, p3), at(3, p0), at(3, p1), at(3, p2), at(3, p3));
#elif defined(__AVX2__)
  constexpr auto at = [](int quarter, int lane) {
    return 4 * quarter + (lane < 4 ? lane : lane - 4 + kLanes);
  };
  return __builtin_shufflevector(a, b, at(0, p0), at(0, p1), at(0, p2), at(0, p3), at(1, p0),
                                 at(1, p1), at(1, p2), at(1, p3));
#else
  return __builtin_shufflevector(a, b, p0, p1, p2, p3);
#endif
}

/// Transposes four vectors that hold the first to the fourth value of each vertex. Then quarter q
/// of vector v holds all four values of vertex 4 q + v.
template <typename Vector> void turn(Vector &a, Vector &b, Vector &c, Vector &d) {
  const Vector abLow = picked<0, 4, 1, 5>(a, b), cdLow = picked<0, 4, 1, 5>(c, d);
  const Vector abHigh = picked<2, 6, 3, 7>(a, b), cdHigh = picked<2, 6, 3, 7>(c, d);
  a = picked<0, 1, 4, 5>(abLow, cdLow);
  b = picked<2, 3, 6, 7>(abLow, cdLow);
  c = picked<0, 1, 4, 5>(abHigh, cdHigh);
  d = picked<2, 3, 6, 7>(abHigh, cdHigh);
}

} // namespace
} // namespace arbiter::swrast
