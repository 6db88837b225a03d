#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/cover/packed.h"
#include "swrast/setup/lanes.h"

/// Computes the planes of up to sixteen triangles at a time, one triangle in each lane. This is
/// compiled once for each instruction set, so include it only in the kernels' sources. Instruction
/// sets must not share functions: hence the unnamed namespace, and no inline function of another
/// header. The steps are those of PlaneSteps in the same order, each one rounded. A pixel's value
/// therefore does not depend on which of the two made its plane.
namespace arbiter::swrast {
namespace {

constexpr int kColumns = abi::PrimitiveColumns::kColumns;
constexpr int kParts = kColumns / kLanes;

/// One number for each triangle of a run, as consecutive vectors.
struct ColumnFloats {
  Floats part[kParts];
};
static_assert(sizeof(ColumnFloats) == kColumns * sizeof(float));

inline void load(const float (&values)[kColumns], ColumnFloats &to) {
  __builtin_memcpy(&to, values, sizeof to);
}

/// Loads element index[k] & mask of the array into lane k.
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

/// The terms from which planes are computed, for a run of triangles of one draw. Lanes beyond the
/// run repeat the last triangle.
struct ColumnTerms {
  /// Differences between corners divided by the area; and the distance from the first pixel's
  /// centre to the first corner.
  ColumnFloats dyOf01, dyOf20, dxOf01, dxOf20, fromX, fromY;
  ColumnFloats inverseW[3];
  std::uint32_t vertex[3][kColumns], provoking[kColumns], backFacing[kColumns];
  bool turns; ///< true if the host's rows run downwards

  ColumnTerms(const RasterState &state, const PackedTriangle *const *triangles, int count)
      : turns(state.upsideDownHeight != 0) {
    float x[3][kColumns], y[3][kColumns], w[3][kColumns];
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
      provoking[k] = small.provokingAndFace >> 1;
      backFacing[k] = small.provokingAndFace & 1;
    }
    ColumnFloats atX[3], atY[3];
    for (int i = 0; i < 3; ++i) {
      load(w[i], inverseW[i]);
      load(x[i], atX[i]);
      load(y[i], atY[i]);
    }
    for (int i = 0; i < kParts; ++i)
      setTerms(i, atX, atY);
  }

  void setTerms(int i, const ColumnFloats (&x)[3], const ColumnFloats (&y)[3]) {
    const Floats x01 = x[0].part[i] - x[1].part[i], y01 = y[0].part[i] - y[1].part[i];
    const Floats x20 = x[2].part[i] - x[0].part[i], y20 = y[2].part[i] - y[0].part[i];
    const Floats area = x01 * y20 - x20 * y01;
    const Floats inverse = (Floats{} + 1.0f) / area;
    dyOf01.part[i] = y01 * inverse;
    dyOf20.part[i] = y20 * inverse;
    dxOf01.part[i] = x01 * inverse;
    dxOf20.part[i] = x20 * inverse;
    fromX.part[i] = x[0].part[i] - 0.5f;
    fromY.part[i] = y[0].part[i] - 0.5f;
  }

  /// Loads a component of the vertices in \p index.
  void fetch(const PlanePlan::Source &source, const std::uint32_t (&index)[kColumns],
             float (&values)[kColumns]) const {
    gather(source.values[0], index, source.mask[0], values);
    if (source.values[0] == source.values[1] && source.mask[0] == source.mask[1])
      return;
    for (int k = 0; k < kColumns; ++k)
      if (backFacing[k] != 0)
        values[k] = source.values[1][index[k] & source.mask[1]];
  }

  /// Computes PlaneSteps::plane() from the values at the corners.
  void plane(const ColumnFloats (&f)[3], float (&out)[3][kColumns]) const {
    ColumnFloats sums[3];
    for (int i = 0; i < kParts; ++i) {
      const Floats f0 = f[0].part[i], f01 = f0 - f[1].part[i], f20 = f[2].part[i] - f0;
      const Floats dx = f01 * dyOf20.part[i] - dyOf01.part[i] * f20;
      const Floats dy = f20 * dxOf01.part[i] - dxOf20.part[i] * f01;
      sums[0].part[i] = f0 - (dx * fromX.part[i] + dy * fromY.part[i]);
      sums[1].part[i] = dx;
      sums[2].part[i] = turns ? -dy : dy;
    }
    __builtin_memcpy(out, sums, sizeof sums);
  }
};

/// Returns the offset of a component's plane in abi::Primitive.
inline std::size_t offsetOf(const PlanePlan::Source &source) {
  return offsetof(abi::Primitive, inputs) +
         sizeof(abi::Plane) * (std::size_t(4) * source.input + source.component);
}

/// Stores columns [first, first + count) of a plane's rows.
inline void storePlane(abi::PrimitiveColumns &to, std::size_t offset, int first, int count,
                       const float (&plane)[3][kColumns]) {
  std::uint32_t(*const rows)[kColumns] = to.rows + offset / 4;
  // If this is the first column, whole rows may be written: later columns are stored afterwards.
  if (first == 0) {
    __builtin_memcpy(rows, plane, sizeof plane);
    return;
  }
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < count; ++k)
      __builtin_memcpy(&rows[row][first + k], &plane[row][k], 4);
}

/// Copies one plane of a primitive into a column.
inline void copyPlane(const abi::Primitive &from, std::size_t offset, int column,
                      abi::PrimitiveColumns &to) {
  for (std::size_t word = 0; word < 3; ++word)
    __builtin_memcpy(&to.rows[offset / 4 + word][column],
                     reinterpret_cast<const char *>(&from) + offset + 4 * word, 4);
}

/// Computes the planes of one triangle as planes.h does.
inline void setColumnOf(const RasterState &state, const PackedTriangle &each, int column,
                        abi::PrimitiveColumns &to) {
  abi::Primitive primitive;
  makePlanes(state, *each.plan, *each.small, each.window, primitive);
  if (each.plan->wantsW)
    copyPlane(primitive, offsetof(abi::Primitive, inverseW), column, to);
  for (int i = 0; i < each.plan->count; ++i)
    copyPlane(primitive, offsetOf(each.plan->sources[i]), column, to);
}

/// Computes the planes of several triangles of one draw.
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
      ColumnFloats f[3];
      for (int corner = 0; corner < 3; ++corner) {
        float values[kColumns];
        terms.fetch(source, terms.vertex[corner], values);
        load(values, f[corner]);
        if (i < plan.linearFrom)
          for (int part = 0; part < kParts; ++part)
            f[corner].part[part] *= terms.inverseW[corner].part[part];
      }
      terms.plane(f, plane);
    }
    storePlane(to, offsetOf(source), first, count, plane);
  }
}

/// Copies a primitive's ready-made planes. Those of unread components may be undefined.
inline void copyColumn(const PackedTriangle &each, int column, abi::PrimitiveColumns &to) {
  copyPlane(*each.made, offsetof(abi::Primitive, inverseW), column, to);
  for (std::size_t plane = 0; plane < std::size_t(4) * each.inputs; ++plane)
    copyPlane(*each.made, offsetof(abi::Primitive, inputs) + plane * sizeof(abi::Plane), column,
              to);
}

/// Implements SetColumns.
void setColumns(const RasterState &state, const PackedTriangle *const *triangles, int count,
                abi::PrimitiveColumns &to) {
  /// The vector code computes all lanes, so it pays only from this many triangles on.
  constexpr int kLeastRun = 2;
  for (int k = 0; k < count; ++k) {
    const PackedTriangle &each = *triangles[k];
    const auto set = [&](std::size_t offset, const void *word) {
      __builtin_memcpy(&to.rows[offset / 4][k], word, 4);
    };
    const std::uint32_t backFacing =
        each.made ? each.made->backFacing : each.small->provokingAndFace & 1;
    set(offsetof(abi::Primitive, backFacing), &backFacing);
    const auto setDepth = [&](std::size_t offset, const void *word) {
      set(offsetof(abi::Primitive, z) + offset, word);
    };
    setDepth(offsetof(abi::DepthPlane, c), &each.depth.c);
    setDepth(offsetof(abi::DepthPlane, dx), &each.depth.dx);
    setDepth(offsetof(abi::DepthPlane, dy), &each.depth.dy);
    setDepth(offsetof(abi::DepthPlane, offset), &each.depth.offset);
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
