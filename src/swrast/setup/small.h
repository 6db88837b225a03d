#pragma once
#include <cstdint>

#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Sets up small triangles, a vector of them at a time. Most triangles of meshes are small.
namespace arbiter::swrast {

/// Limit of a small triangle's snapped width and height. Its edge functions then fit 32 bits
/// nearby.
inline constexpr std::int32_t kSmallExtent = 64 * kSubpixels;

/// A small triangle that is at least partly visible, with all that tiles need to find its pixels
/// and their depths. It fills one cache line: four vectors of 16 bytes.
struct alignas(16) SmallTriangle {
  std::uint32_t vertex[3];               ///< in the hosts' order (HostOrder)
  std::uint32_t provokingAndFace;        ///< the lowest bit is set if it is back-facing
  std::int16_t left, bottom, right, top; ///< pixels, half-open, within the draw's clip rectangle
  /// the lower left pixel, limited by the image but not by the clip rectangle
  std::int16_t originX, originY;
  /// A pixel is inside if a * (x - originX) + b * (y - originY) + c >= 0 for all three edges,
  /// counterclockwise. a and b of the third edge are the negative sums of the others.
  std::int16_t a[2], b[2];
  std::int32_t c[3];
  float depth[4]; ///< c, dx, dy and offset of an abi::DepthPlane

  [[nodiscard]] std::uint32_t provoking() const { return provokingAndFace >> 1; }
  [[nodiscard]] bool isBackFacing() const { return (provokingAndFace & 1) != 0; }
  [[nodiscard]] abi::DepthPlane depthPlane() const {
    return {depth[0], depth[1], depth[2], depth[3]};
  }
};
static_assert(sizeof(SmallTriangle) == 64);

struct SmallSetUp;
struct TriangleGroup;
struct GroupSetUp;
/// Sets up a group of triangles.
/// \param to receives the small ones in order; has room for TriangleGroup::kMax
using SetUpSmall = GroupSetUp (*)(const SmallSetUp &with, const WindowVertex *window,
                                  const TriangleGroup &group, SmallTriangle *to);

/// The state of a draw that setup of small triangles needs.
struct SmallSetUp {
  /// \param visible pixels that the draw may reach; none beyond 32767
  SmallSetUp(const RasterState &state, const Rect &visible);
  Rect clip; ///< in pixels
  bool frontIsClockwise, cullFront, cullBack, provokingIsFirst;
  bool offset; ///< true if there is polygon offset
  float offsetFactor, offsetConstant;
  int upsideDownHeight;
  SetUpSmall kernel; ///< the best one for this processor
};

/// Triangles that are set up together.
struct TriangleGroup {
  static constexpr int kMax = 16;
  std::uint32_t vertex[3][kMax], provoking[kMax]; ///< valid indices, for the first `count`
  int count = 0;
};

/// The results of a group, one bit for each triangle. Triangles with no bit are not visible.
struct GroupSetUp {
  unsigned small = 0; ///< set up as small triangles
  unsigned other = 0; ///< must be clipped, or not small
  /// Part of `small`: triangles with almost no area, whose depth plane must still be made
  /// (makeDepthPlane()).
  unsigned depthless = 0;
};

/// One function for each useful instruction set. All give the same bits as setBounds(),
/// edgeBetween() and makeDepthPlane().
GroupSetUp setUpSmallBaseline(const SmallSetUp &with, const WindowVertex *window,
                              const TriangleGroup &group, SmallTriangle *to);
GroupSetUp setUpSmallAvx2(const SmallSetUp &with, const WindowVertex *window,
                          const TriangleGroup &group, SmallTriangle *to);
GroupSetUp setUpSmallAvx512(const SmallSetUp &with, const WindowVertex *window,
                            const TriangleGroup &group, SmallTriangle *to);

/// Returns a small triangle with its corners, as needed to compute planes.
[[nodiscard]] Triangle triangleOf(const SmallTriangle &small, const WindowVertex *window);
/// Returns the steps that compute its planes.
[[nodiscard]] PlaneSteps stepsOf(const RasterState &state, const SmallTriangle &small,
                                 const WindowVertex *window);
/// Computes all of its planes but that of depth, which it already has.
void makePlanes(const RasterState &state, const PlanePlan &plan, const SmallTriangle &small,
                const WindowVertex *window, abi::Primitive &primitive);

} // namespace arbiter::swrast
