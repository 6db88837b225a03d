#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "swrast/rasterize.h"

/// The same primitives drawn by OSMesa and by the rasterizer; each pixel counts how often it was
/// drawn to.
namespace arbiter::raster_test {

struct Scene {
  int width = 64, height = 64;
  swrast::Topology topology = swrast::Topology::Triangles;
  std::vector<std::array<float, 4>> vertices;    ///< in clip space
  std::vector<std::uint8_t> edgeFlags;           ///< empty: all set
  std::vector<std::array<double, 4>> clipPlanes; ///< of the user, in clip space
  swrast::RasterState state; ///< viewport, clip and depth range 0 to 1 are the canvas's

  /// In window coordinates, at the given w.
  void add(double x, double y, double w = 1, double z = 0);
};

using Counts = std::vector<std::uint32_t>;
/// Hosts keep windows upside down, and framebuffer objects not.
enum class Target { Window, FramebufferObject };
/// RasterState::lineEndsAsEdges of the host: llvmpipe's lines are others from Mesa 23.2 on.
[[nodiscard]] bool hostCutsLinesAsEdges();
/// Empty where there is no OSMesa context.
[[nodiscard]] Counts drawByHost(const Scene &scene, Target target);
/// `lanes`: of quad blocks; 0: rows.
[[nodiscard]] Counts drawByUs(const Scene &scene, Target target, int lanes = 0);

/// Pixels that differ, and a picture of the first ones as text.
struct Difference {
  int pixels = 0;
  int covered = 0; ///< by the host
  std::string text;
};
[[nodiscard]] Difference compare(const Scene &scene, const Counts &host, const Counts &drawn);

} // namespace arbiter::raster_test
