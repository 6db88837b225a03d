#pragma once
#include <cstdint>

#include "swrast/setup/draw.h"
#include "swrast/setup/shape.h"

/// Small triangles, set up a vector at a time: most of what real programs draw in meshes.
namespace arbiter::swrast {

/// Triangles whose snapped corners are less than this apart, in x and in y: their edge functions
/// fit 32 bits near them.
inline constexpr std::int32_t kSmallExtent = 64 * kSubpixels;

/// A small triangle that is seen in part at least: all that tiles need of it to find its pixels and
/// their depths. One line of the cache, four vectors of 16 bytes.
struct alignas(16) SmallTriangle {
  std::uint32_t vertex[3];               ///< in the order of hosts (HostOrder)
  std::uint32_t provokingAndFace;        ///< the lowest bit: it is back facing
  std::int16_t left, bottom, right, top; ///< pixels, half open, within the draw's clip rectangle
  std::int16_t originX, originY;         ///< the lower left pixel, within the image but not clipped
  /// Inside where all three a * (x - originX) + b * (y - originY) + c >= 0, counterclockwise; those
  /// of the third edge are what closes the triangle.
  std::int16_t a[2], b[2];
  std::int32_t c[3];
  float depth[4]; ///< c, dx, dy and offset of its abi::DepthPlane

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
/// Sets up a group. \param to room for TriangleGroup::kMost; the small ones, in order
using SetUpSmall = GroupSetUp (*)(const SmallSetUp &with, const WindowVertex *window,
                                  const TriangleGroup &group, SmallTriangle *to);

/// What a draw's small triangles are set up with.
struct SmallSetUp {
  /// \param visible pixels that the draw may reach, none beyond 32767
  SmallSetUp(const RasterState &state, const Rect &visible);
  Rect clip; ///< pixels
  bool frontIsClockwise, cullFront, cullBack, provokingIsFirst;
  bool offset; ///< there is polygon offset
  float offsetFactor, offsetConstant;
  int upsideDownHeight;
  SetUpSmall kernel; ///< the best that this processor runs
};

/// Triangles that are looked at together.
struct TriangleGroup {
  static constexpr int kMost = 16;
  std::uint32_t vertex[3][kMost], provoking[kMost]; ///< of `count`, numbers that there are
  int count = 0;
};

/// What they turned out to be, a bit each; those in none of these are not seen.
struct GroupSetUp {
  unsigned small = 0; ///< set up
  unsigned other = 0; ///< to be clipped, or not small
  /// Of `small`: they have next to no area, so that their depths are still to be made
  /// (makeDepthPlane()).
  unsigned depthless = 0;
};

/// One for each instruction set that pays; all give the same to the bit: what setBounds(),
/// edgeBetween() and makeDepthPlane() say.
GroupSetUp setUpSmallBaseline(const SmallSetUp &with, const WindowVertex *window,
                              const TriangleGroup &group, SmallTriangle *to);
GroupSetUp setUpSmallAvx2(const SmallSetUp &with, const WindowVertex *window,
                          const TriangleGroup &group, SmallTriangle *to);
GroupSetUp setUpSmallAvx512(const SmallSetUp &with, const WindowVertex *window,
                            const TriangleGroup &group, SmallTriangle *to);

/// A small triangle with its corners, as planes are made of it.
[[nodiscard]] Triangle triangleOf(const SmallTriangle &small, const WindowVertex *window);
/// Returns the steps that its planes are made with.
[[nodiscard]] PlaneSteps stepsOf(const RasterState &state, const SmallTriangle &small,
                                 const WindowVertex *window);
/// All of its planes but that of depth, which has been made.
void makePlanes(const RasterState &state, const PlanePlan &plan, const SmallTriangle &small,
                const WindowVertex *window, abi::Primitive &primitive);

} // namespace arbiter::swrast
