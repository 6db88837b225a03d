#include "swrast/setup/small.h"

#include "swrast/setup/small_block.h"
#include "util/processor.h"

namespace arbiter::swrast {

namespace {
SetUpSmall chosenKernel() {
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() == Vectors::Avx512)
    return setUpSmallAvx512;
  if (vectors() == Vectors::Avx2)
    return setUpSmallAvx2;
#endif
  return setUpSmallBaseline;
}
} // namespace

SmallSetUp::SmallSetUp(const RasterState &state, const Rect &visible)
    : clip(visible), frontIsClockwise(state.frontIsClockwise), cullFront(state.cullFront),
      cullBack(state.cullBack), provokingIsFirst(state.provokingIsFirst), offset(state.offsetFill),
      offsetFactor(state.offsetFactor),
      offsetConstant(float(state.depthResolution * state.offsetUnits)),
      upsideDownHeight(state.upsideDownHeight), kernel(chosenKernel()) {}

GroupSetUp setUpSmallBaseline(const SmallSetUp &with, const WindowVertex *window,
                              const TriangleGroup &group, SmallTriangle *to) {
  return setUpGroup(with, window, group, to);
}

Triangle triangleOf(const SmallTriangle &small, const WindowVertex *window) {
  Triangle triangle;
  for (int k = 0; k < 3; ++k) {
    triangle.vertex[k] = small.vertex[k];
    triangle.corner[k] = window[small.vertex[k]];
  }
  triangle.provoking = small.provoking();
  triangle.backFacing = small.isBackFacing();
  return triangle;
}

PlaneSteps stepsOf(const RasterState &state, const SmallTriangle &small,
                   const WindowVertex *window) {
  return {state, {&window[small.vertex[0]], &window[small.vertex[1]], &window[small.vertex[2]]}};
}

void makePlanes(const RasterState &state, const PlanePlan &plan, const SmallTriangle &small,
                const WindowVertex *window, abi::Primitive &primitive) {
  constexpr int kOrder[3] = {0, 1, 2};
  makePlanes(plan, triangleOf(small, window), stepsOf(state, small, window), kOrder, primitive);
}

} // namespace arbiter::swrast
