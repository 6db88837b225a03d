#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "swrast/rasterize.h"

/// Draws the same primitives by OSMesa and by the rasterizer; each pixel counts how often it was
/// drawn to.
namespace arbiter::raster_test {

struct Scene {
  int width = 64, height = 64;
  swrast::Topology topology = swrast::Topology::Triangles;
  std::vector<std::array<float, 4>> vertices;    ///< in clip space
  std::vector<std::uint8_t> edgeFlags;           ///< empty: all set
  std::vector<std::array<double, 4>> clipPlanes; ///< user clip planes, in clip space
  swrast::RasterState state; ///< viewport, clip and depth range 0 to 1 are set from the canvas

  /// Adds a vertex in window coordinates, at the given w.
  void add(double x, double y, double w = 1, double z = 0);
};

using Counts = std::vector<std::uint32_t>;
/// The kind of target; hosts store windows upside down, but not framebuffer objects.
enum class Target { Window, FramebufferObject };
/// Returns RasterState::lineEndsAsEdges of the host: llvmpipe's lines changed in Mesa 23.2.
[[nodiscard]] bool hostCutsLinesAsEdges();
/// Draws by the host; empty if there is no OSMesa context.
[[nodiscard]] Counts drawByHost(const Scene &scene, Target target);
/// Draws by the rasterizer. `lanes`: of quad blocks; 0: rows.
[[nodiscard]] Counts drawByUs(const Scene &scene, Target target, int lanes = 0);

/// The number of differing pixels, and a picture of the first ones as text.
struct Difference {
  int pixels = 0;
  int covered = 0; ///< by the host
  std::string text;
};
[[nodiscard]] Difference compare(const Scene &scene, const Counts &host, const Counts &drawn);

} // namespace arbiter::raster_test
