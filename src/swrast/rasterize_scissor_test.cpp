// Checks that a scissored draw gives the pixels inside the scissor the same values as the whole
// draw.
#include <gtest/gtest.h>
#include <memory>
#include <random>

#include "swrast/testing/canvas.h"

namespace arbiter::swrast {
namespace {

using testing::addInput;
using testing::Canvas;
using testing::drawAll;
using testing::WindowVertices;

/// Draws `triangles` triangles, or one rectangle if that is 0, with the given scissor.
void drawValues(Canvas &canvas, std::uint32_t seed, int triangles, const Rect &scissor) {
  addInput(canvas, abi::Interpolation::Linear);
  canvas.state.clip = scissor;
  std::mt19937 random(seed);
  // Triangles may leave the canvas, and some are small.
  std::uniform_real_distribution<double> at(-120, 360), beside(-9, 9), value(-3, 3);
  WindowVertices vertices(canvas);
  if (triangles == 0) {
    const double left = at(random), bottom = at(random), right = at(random), top = at(random);
    for (const auto &[x, y] : {std::pair{left, bottom}, {right, bottom}, {right, top}, {left, top}})
      vertices.add(x, y, float(x * 0.37 + y * 0.11));
    drawAll(canvas, Topology::Quads, vertices);
    return;
  }
  for (int i = 0; i < triangles; ++i) {
    const double x = at(random), y = at(random);
    const bool small = i % 2 == 1;
    for (int k = 0; k < 3; ++k)
      vertices.add(small ? x + beside(random) : at(random), small ? y + beside(random) : at(random),
                   float(value(random)));
  }
  drawAll(canvas, Topology::Triangles, vertices);
}

/// OpenGL 2.1, appendix A, rule 2: changing the scissor box has no side effects. Applications rely
/// on it: they draw a scene's depths first, then each light's part of the scene with GL_EQUAL.
TEST(Rasterize, AScissorChangesNoValueOfWhatItLeaves) {
  for (const int lanes : {0, 4, 8, 16})
    for (const int triangles : {0, 1, 3, 40})
      for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const auto make = [&](const Rect &scissor) {
          auto canvas = std::make_unique<Canvas>(240, 240);
          if (lanes != 0)
            canvas->useQuads(lanes);
          drawValues(*canvas, seed, triangles, scissor);
          return canvas;
        };
        const auto whole = make({0, 0, 240, 240});
        for (const Rect &part : {Rect{7, 3, 2, 2}, Rect{65, 130, 100, 70}, Rect{0, 201, 240, 1}}) {
          const auto cut = make(part);
          for (int y = part.y; y < part.y + part.height; ++y)
            for (int x = part.x; x < part.x + part.width; ++x) {
              ASSERT_EQ(cut->at(x, y), whole->at(x, y)) << x << ' ' << y;
              ASSERT_EQ(cut->valueAt(x, y), whole->valueAt(x, y))
                  << x << ' ' << y << " of " << triangles << ", seed " << seed;
            }
        }
      }
}

} // namespace
} // namespace arbiter::swrast
