#pragma once
#include <cstddef>
#include <cstdint>

#include "swrast/cover/packed.h"

/// The planes of up to sixteen triangles at a time, a lane each, compiled once for each instruction
/// set: include it only where its kernels are made. Nothing in here may be shared between those,
/// hence the nameless namespace and no inline function of another header. The steps are those of
/// planes.h in the same order, each rounded, so that a pixel's value does not depend on which of
/// them made its plane.
namespace arbiter::swrast {
namespace {

constexpr int kColumns = abi::PrimitiveColumns::kColumns;

/// What planes are made of, of a run of triangles of one draw; behind the last its fields again.
struct ColumnTerms {
  double dx1[kColumns], dx2[kColumns], dy1[kColumns], dy2[kColumns], toX[kColumns], toY[kColumns];
  double inverseW[3][kColumns];
  std::uint32_t vertex[3][kColumns], provoking[kColumns];
  bool backFacing[kColumns];

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
      backFacing[k] = (small.provokingAndFace & 1) != 0;
    }
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < kColumns; ++k)
        inverseW[i][k] = w[i][k];
    // gradientsOf()
    double area[kColumns];
    const double sign = state.upsideDownHeight != 0 ? -1.0 : 1.0;
    const double bottom = state.upsideDownHeight;
    for (int k = 0; k < kColumns; ++k) {
      const double x0 = x[0][k], y0 = y[0][k];
      const double x1 = x[1][k] - x0, y1 = sign * (y[1][k] - y0);
      const double x2 = x[2][k] - x0, y2 = sign * (y[2][k] - y0);
      area[k] = x1 * y2 - x2 * y1;
      const double inverse = 1.0 / area[k];
      dx1[k] = y2 * inverse;
      dx2[k] = -y1 * inverse;
      dy1[k] = -x2 * inverse;
      dy2[k] = x1 * inverse;
      toX[k] = originX[k] + 0.5 - x0;
      toY[k] = originY[k] + 0.5 - (sign < 0 ? bottom - y0 : y0);
    }
    for (int k = 0; k < kColumns; ++k)
      if (__builtin_fabs(area[k]) < kThinArea)
        setGradients(state, *triangles[k < count ? k : count - 1], k);
  }

  /// Of one that is thin.
  void setGradients(const RasterState &state, const PackedTriangle &each, int k) {
    const Triangle triangle = triangleOf(*each.small, each.window);
    const Gradients gradients =
        gradientsOf(state, triangle.corner, each.small->originX, each.small->originY);
    dx1[k] = gradients.dx1;
    dx2[k] = gradients.dx2;
    dy1[k] = gradients.dy1;
    dy2[k] = gradients.dy2;
    toX[k] = gradients.toX;
    toY[k] = gradients.toY;
  }

  /// A component of the vertices in \p index.
  void fetch(const PlanePlan::Source &source, const std::uint32_t *index, float *values) const {
    const float *const front = source.values[0], *const back = source.values[1];
    const std::uint32_t frontMask = source.mask[0], backMask = source.mask[1];
    if (front == back && frontMask == backMask) {
      for (int k = 0; k < kColumns; ++k)
        values[k] = front[index[k] & frontMask];
      return;
    }
    for (int k = 0; k < kColumns; ++k)
      values[k] = backFacing[k] ? back[index[k] & backMask] : front[index[k] & frontMask];
  }

  /// Gradients::plane() of values at the corners.
  void plane(const double (&f)[3][kColumns], float (&out)[3][kColumns]) const {
    for (int k = 0; k < kColumns; ++k) {
      const double f0 = f[0][k], d1 = f[1][k] - f0, d2 = f[2][k] - f0;
      const double dx = d1 * dx1[k] + d2 * dx2[k], dy = d1 * dy1[k] + d2 * dy2[k];
      const double c = f0 + dx * toX[k] + dy * toY[k], level = f0 + 0.0;
      const bool isLevel = (d1 == 0) & (d2 == 0);
      out[0][k] = float(isLevel ? level : c);
      out[1][k] = float(isLevel ? 0.0 : dx);
      out[2][k] = float(isLevel ? 0.0 : dy);
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
    const std::size_t offset = offsetOf(source);
    if (i >= plan.flatFrom) {
      terms.fetch(source, terms.provoking, plane[0]);
      for (int k = 0; k < kColumns; ++k)
        plane[1][k] = plane[2][k] = 0;
    } else {
      float values[3][kColumns];
      double f[3][kColumns];
      for (int corner = 0; corner < 3; ++corner)
        terms.fetch(source, terms.vertex[corner], values[corner]);
      const bool perspective = i < plan.linearFrom;
      for (int corner = 0; corner < 3; ++corner)
        for (int k = 0; k < kColumns; ++k)
          f[corner][k] = perspective ? values[corner][k] * terms.inverseW[corner][k]
                                     : double(values[corner][k]);
      terms.plane(f, plane);
    }
    storePlane(to, offset, first, count, plane);
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
  const Triangle triangle = triangleOf(*each.small, each.window);
  const int originX = each.small->originX, originY = each.small->originY;
  const Gradients gradients = gradientsOf(state, triangle.corner, originX, originY);
  abi::Primitive primitive;
  makePlanes(*each.plan, triangle, gradients, originX, originY, primitive);
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
  constexpr int kLeastRun = 4;
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
