#include "common/rasterize.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace demos {
namespace {

constexpr std::int64_t kSubpixels = 256;

struct WindowVertex {
  std::int64_t x, y; ///< in subpixels
  double z;          ///< in [0,1]
  double inverseW;
};

WindowVertex toWindow(const glm::vec4 &clip, int width, int height) {
  const double inverseW = 1.0 / double(clip.w);
  const auto snap = [](double pixels) { return std::llround(pixels * double(kSubpixels)); };
  return {snap((double(clip.x) * inverseW * 0.5 + 0.5) * width),
          snap((double(clip.y) * inverseW * 0.5 + 0.5) * height),
          double(clip.z) * inverseW * 0.5 + 0.5, inverseW};
}

/// Returns twice the area of (a, b, p): positive if p is to the left of the edge.
std::int64_t edge(const WindowVertex &a, const WindowVertex &b, std::int64_t x, std::int64_t y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// True if a pixel center exactly on the edge belongs to a counter-clockwise triangle (y up): on
/// left edges (going down) and top ones (going left). Any fixed rule shades shared edges once.
bool ownsBorder(const WindowVertex &a, const WindowVertex &b) {
  return b.y < a.y || (b.y == a.y && b.x < a.x);
}

} // namespace

void Rasterizer::triangle(const RasterVertex &first, const RasterVertex &second,
                          const RasterVertex &third, const Shader &shader) {
  const RasterVertex *in[3] = {&first, &second, &third};
  WindowVertex v[3];
  for (int i = 0; i < 3; ++i)
    v[i] = toWindow(in[i]->clip, m_width, m_height);
  if (edge(v[0], v[1], v[2].x, v[2].y) < 0) {
    std::swap(v[1], v[2]);
    std::swap(in[1], in[2]);
  }
  const std::int64_t twiceArea = edge(v[0], v[1], v[2].x, v[2].y);
  if (twiceArea == 0)
    return;
  const auto [minX, maxX] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [minY, maxY] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int lastX = std::min<int>(m_width - 1, int(maxX / kSubpixels));
  const int lastY = std::min<int>(m_height - 1, int(maxY / kSubpixels));
  for (int y = std::max(0, int(minY / kSubpixels)); y <= lastY; ++y) {
    for (int x = std::max(0, int(minX / kSubpixels)); x <= lastX; ++x) {
      const std::int64_t px = x * kSubpixels + kSubpixels / 2, py = y * kSubpixels + kSubpixels / 2;
      double weights[3];
      bool inside = true;
      for (int i = 0; i < 3; ++i) {
        const WindowVertex &from = v[(i + 1) % 3], &to = v[(i + 2) % 3];
        const std::int64_t side = edge(from, to, px, py);
        inside = inside && (side > 0 || (side == 0 && ownsBorder(from, to)));
        weights[i] = double(side) / double(twiceArea);
      }
      if (!inside)
        continue;
      const double z = weights[0] * v[0].z + weights[1] * v[1].z + weights[2] * v[2].z;
      double &depth = m_depth[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
      if (z >= depth)
        continue;
      depth = z;
      double sum = 0;
      for (int i = 0; i < 3; ++i)
        sum += weights[i] *= v[i].inverseW;
      glm::vec3 varyings[2] = {glm::vec3(0), glm::vec3(0)};
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k)
          varyings[k] += in[i]->varyings[k] * float(weights[i] / sum);
      shader(x, y, varyings);
    }
  }
}

} // namespace demos
