#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/cover/packed.h"
#include "swrast/setup/lanes.h"

/// The planes of up to sixteen triangles at a time, a lane each, compiled once for each instruction
/// set: include it only where its kernels are made. Nothing in here may be shared between those,
/// hence the nameless namespace and no inline function of another header. The steps are those of
/// planes.h in the same order, each rounded, so that a pixel's value does not depend on which of
/// them made its plane.
namespace arbiter::swrast {
namespace {

constexpr int kColumns = abi::PrimitiveColumns::kColumns;
constexpr int kDoubles = kLanes / 2; ///< doubles of a vector

/// Numbers of a run of triangles as doubles, a vector behind the other.
struct ColumnDoubles {
  Doubles part[kColumns / kDoubles];
};

inline void widen(const float (&values)[kColumns], ColumnDoubles &to) {
  for (int i = 0; i < kColumns / kDoubles; ++i) {
    HalfFloats half;
    __builtin_memcpy(&half, values + i * kDoubles, sizeof half);
    to.part[i] = widened(half);
  }
}
inline void widen(const std::int32_t (&values)[kColumns], ColumnDoubles &to) {
  for (int i = 0; i < kColumns / kDoubles; ++i) {
    HalfInts half;
    __builtin_memcpy(&half, values + i * kDoubles, sizeof half);
    to.part[i] = widened(half);
  }
}

/// Element index[k] & mask of an array in lane k.
inline void gather(const float *from, const std::uint32_t (&index)[kColumns], std::uint32_t mask,
                   float (&values)[kColumns]) {
#if defined(__AVX512F__)
  const __m512i at = _mm512_and_si512(_mm512_loadu_si512(index), _mm512_set1_epi32(int(mask)));
  _mm512_storeu_ps(values, _mm512_i32gather_ps(at, from, 4));
#else
  for (int k = 0; k < kColumns; ++k)
    values[k] = from[index[k] & mask];
#endif
}

/// What planes are made of, of a run of triangles of one draw; behind the last its fields again.
struct ColumnTerms {
  ColumnDoubles dx1, dx2, dy1, dy2, toX, toY; ///< Gradients
  ColumnDoubles inverseW[3];
  std::uint32_t vertex[3][kColumns], provoking[kColumns], backFacing[kColumns];

  ColumnTerms(const RasterState &state, const PackedTriangle *const *triangles, int count) {
    float x[3][kColumns], y[3][kColumns], w[3][kColumns];
    std::int32_t originX[kColumns], originY[kColumns];
    for (int k = 0; k < kColumns; ++k) {
      const PackedTriangle &each = *triangles[k < count ? k : count - 1];
      const SmallTriangle &small = *each.small;
      for (int i = 0; i < 3; ++i) {
        const WindowVertex &corner = each.window[small.vertex[i]];
        vertex[i][k] = small.vertex[i];
        x[i][k] = corner.x;
        y[i][k] = corner.y;
        w[i][k] = corner.inverseW;
      }
      originX[k] = small.originX;
      originY[k] = small.originY;
      provoking[k] = small.provokingAndFace >> 1;
      backFacing[k] = small.provokingAndFace & 1;
    }
    for (int i = 0; i < 3; ++i)
      widen(w[i], inverseW[i]);
    ColumnDoubles wideX[3], wideY[3];
    for (int i = 0; i < 3; ++i) {
      widen(x[i], wideX[i]);
      widen(y[i], wideY[i]);
    }
    widen(originX, toX);
    widen(originY, toY);
    for (int i = 0; i < kColumns / kDoubles; ++i) {
      for (unsigned thin = lanesIn(setGradients(state, i, wideX, wideY)); thin != 0;
           thin &= thin - 1) {
        const int k = __builtin_ctz(thin), column = i * kDoubles + k;
        setThin(state, *triangles[column < count ? column : count - 1], i, k);
      }
    }
  }

  /// gradientsOf() of a vector, whose origins are in toX and toY. \return those that are thin
  Longs setGradients(const RasterState &state, int i, const ColumnDoubles (&x)[3],
                     const ColumnDoubles (&y)[3]) {
    const bool isUpsideDown = state.upsideDownHeight != 0;
    const Doubles x0 = x[0].part[i], y0 = y[0].part[i];
    const Doubles x1 = x[1].part[i] - x0, x2 = x[2].part[i] - x0;
    Doubles y1 = y[1].part[i] - y0, y2 = y[2].part[i] - y0, bottom = y0;
    if (isUpsideDown) {
      y1 = -y1;
      y2 = -y2;
      bottom = double(state.upsideDownHeight) - y0;
    }
    const Doubles area = x1 * y2 - x2 * y1;
    const Doubles inverse = 1.0 / area;
    dx1.part[i] = y2 * inverse;
    dx2.part[i] = -y1 * inverse;
    dy1.part[i] = -x2 * inverse;
    dy2.part[i] = x1 * inverse;
    toX.part[i] = toX.part[i] + 0.5 - x0;
    toY.part[i] = toY.part[i] + 0.5 - bottom;
    return (area < kThinArea) & (area > -kThinArea);
  }

  void setThin(const RasterState &state, const PackedTriangle &each, int i, int k) {
    const Gradients gradients = gradientsOf(state, *each.small, each.window);
    dx1.part[i][k] = gradients.dx1;
    dx2.part[i][k] = gradients.dx2;
    dy1.part[i][k] = gradients.dy1;
    dy2.part[i][k] = gradients.dy2;
    toX.part[i][k] = gradients.toX;
    toY.part[i][k] = gradients.toY;
  }

  /// A component of the vertices in \p index.
  void fetch(const PlanePlan::Source &source, const std::uint32_t (&index)[kColumns],
             float (&values)[kColumns]) const {
    gather(source.values[0], index, source.mask[0], values);
    if (source.values[0] == source.values[1] && source.mask[0] == source.mask[1])
      return;
    for (int k = 0; k < kColumns; ++k)
      if (backFacing[k] != 0)
        values[k] = source.values[1][index[k] & source.mask[1]];
  }

  /// Gradients::plane() of values at the corners.
  void plane(const ColumnDoubles (&f)[3], float (&out)[3][kColumns]) const {
    for (int i = 0; i < kColumns / kDoubles; ++i) {
      const Doubles f0 = f[0].part[i], d1 = f[1].part[i] - f0, d2 = f[2].part[i] - f0;
      Doubles dx = d1 * dx1.part[i] + d2 * dx2.part[i];
      Doubles dy = d1 * dy1.part[i] + d2 * dy2.part[i];
      Doubles c = f0 + dx * toX.part[i] + dy * toY.part[i];
      const Longs isLevel = (d1 == 0) & (d2 == 0);
      const Doubles none{};
      c = isLevel ? f0 + 0.0 : c;
      dx = isLevel ? none : dx;
      dy = isLevel ? none : dy;
      const Doubles *const sums[3] = {&c, &dx, &dy};
      for (int row = 0; row < 3; ++row) {
        const HalfFloats half = narrowed(*sums[row]);
        __builtin_memcpy(out[row] + i * kDoubles, &half, sizeof half);
      }
    }
  }
};

/// Of a component's plane in a Primitive.
inline std::size_t offsetOf(const PlanePlan::Source &source) {
  return offsetof(abi::Primitive, inputs) +
         sizeof(abi::Plane) * (std::size_t(4) * source.input + source.component);
}

/// Columns [first, first + count) of a plane's rows.
inline void storePlane(abi::PrimitiveColumns &to, std::size_t offset, int first, int count,
                       const float (&plane)[3][kColumns]) {
  std::uint32_t(*const rows)[kColumns] = to.rows + offset / 4;
  // From the first column on all may be written: columns behind these are made later.
  if (first == 0) {
    __builtin_memcpy(rows, plane, sizeof plane);
    return;
  }
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < count; ++k)
      __builtin_memcpy(&rows[row][first + k], &plane[row][k], 4);
}

/// Of triangles of one draw.
inline void setColumnsOf(const RasterState &state, const PlanePlan &plan,
                         const PackedTriangle *const *triangles, int first, int count,
                         abi::PrimitiveColumns &to) {
  const ColumnTerms terms(state, triangles, count);
  float plane[3][kColumns];
  if (plan.wantsW) {
    terms.plane(terms.inverseW, plane);
    storePlane(to, offsetof(abi::Primitive, inverseW), first, count, plane);
  }
  for (int i = 0; i < plan.count; ++i) {
    const PlanePlan::Source &source = plan.sources[i];
    if (i >= plan.flatFrom) {
      terms.fetch(source, terms.provoking, plane[0]);
      for (int k = 0; k < kColumns; ++k)
        plane[1][k] = plane[2][k] = 0;
    } else {
      ColumnDoubles f[3];
      for (int corner = 0; corner < 3; ++corner) {
        float values[kColumns];
        terms.fetch(source, terms.vertex[corner], values);
        widen(values, f[corner]);
        if (i < plan.linearFrom)
          for (int part = 0; part < kColumns / kDoubles; ++part)
            f[corner].part[part] *= terms.inverseW[corner].part[part];
      }
      terms.plane(f, plane);
    }
    storePlane(to, offsetOf(source), first, count, plane);
  }
}

/// A plane of a primitive.
inline void copyPlane(const abi::Primitive &from, std::size_t offset, int column,
                      abi::PrimitiveColumns &to) {
  for (std::size_t word = 0; word < 3; ++word)
    __builtin_memcpy(&to.rows[offset / 4 + word][column],
                     reinterpret_cast<const char *>(&from) + offset + 4 * word, 4);
}

/// One triangle's planes, as planes.h makes them.
inline void setColumnOf(const RasterState &state, const PackedTriangle &each, int column,
                        abi::PrimitiveColumns &to) {
  abi::Primitive primitive;
  makePlanes(state, *each.plan, *each.small, each.window, primitive);
  if (each.plan->wantsW)
    copyPlane(primitive, offsetof(abi::Primitive, inverseW), column, to);
  for (int i = 0; i < each.plan->count; ++i)
    copyPlane(primitive, offsetOf(each.plan->sources[i]), column, to);
}

/// Planes that are made. Those of components that nothing reads may be anything.
inline void copyColumn(const PackedTriangle &each, int column, abi::PrimitiveColumns &to) {
  copyPlane(*each.made, offsetof(abi::Primitive, inverseW), column, to);
  for (std::size_t plane = 0; plane < std::size_t(4) * each.inputs; ++plane)
    copyPlane(*each.made, offsetof(abi::Primitive, inputs) + plane * sizeof(abi::Plane), column,
              to);
}

/// SetColumns
void setColumns(const RasterState &state, const PackedTriangle *const *triangles, int count,
                abi::PrimitiveColumns &to) {
  /// All lanes are computed for any number of triangles.
  constexpr int kLeastRun = 2;
  for (int k = 0; k < count; ++k) {
    const PackedTriangle &each = *triangles[k];
    const auto set = [&](std::size_t offset, const void *word) {
      __builtin_memcpy(&to.rows[offset / 4][k], word, 4);
    };
    const std::int32_t originX = each.made ? each.made->originX : each.small->originX;
    const std::int32_t originY = each.made ? each.made->originY : each.small->originY;
    const std::uint32_t backFacing =
        each.made ? each.made->backFacing : each.small->provokingAndFace & 1;
    set(offsetof(abi::Primitive, originX), &originX);
    set(offsetof(abi::Primitive, originY), &originY);
    set(offsetof(abi::Primitive, backFacing), &backFacing);
    const auto setDepth = [&](std::size_t offset, const void *word) {
      set(offsetof(abi::Primitive, z) + offset, word);
    };
    setDepth(offsetof(abi::DepthPlane, c), &each.depth.c);
    setDepth(offsetof(abi::DepthPlane, dx), &each.depth.dx);
    setDepth(offsetof(abi::DepthPlane, dy), &each.depth.dy);
    setDepth(offsetof(abi::DepthPlane, offset), &each.depth.offset);
    setDepth(offsetof(abi::DepthPlane, originY), &each.depth.originY);
  }
  for (int first = 0; first < count;) {
    if (triangles[first]->made) {
      copyColumn(*triangles[first], first, to);
      ++first;
      continue;
    }
    const PlanePlan *const plan = triangles[first]->plan;
    int end = first + 1;
    while (end < count && !triangles[end]->made && triangles[end]->plan == plan)
      ++end;
    if (end - first >= kLeastRun)
      setColumnsOf(state, *plan, triangles + first, first, end - first, to);
    else
      for (int k = first; k < end; ++k)
        setColumnOf(state, *triangles[k], k, to);
    first = end;
  }
}

} // namespace
} // namespace arbiter::swrast
