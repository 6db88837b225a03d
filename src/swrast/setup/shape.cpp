#include "swrast/setup/shape.h"

namespace arbiter::swrast {

Edge edgeBetween(const WindowVertex &from, const WindowVertex &to) {
  Edge edge;
  edge.a = from.fixedY - to.fixedY;
  edge.b = to.fixedX - from.fixedX;
  std::int64_t c = -(std::int64_t(edge.a) * from.fixedX + std::int64_t(edge.b) * from.fixedY);
  // A centre on a left or a lower edge is inside; on any other edge it belongs to the neighbour.
  if (!(edge.a > 0 || (edge.a == 0 && edge.b > 0)))
    --c;
  // Pixels are 256 units apart, so the low bits never decide.
  edge.c = c >> kSubpixelBits;
  return edge;
}

bool shapeOf(const Rect &clip, const WindowVertex corner[3], std::int64_t area, Shape &shape) {
  if (!setBounds(clip, corner, 3, shape))
    return false;
  const int second = area > 0 ? 1 : 2, third = 3 - second;
  shape.edgeCount = 3;
  shape.edges[0] = edgeBetween(corner[0], corner[second]);
  shape.edges[1] = edgeBetween(corner[second], corner[third]);
  shape.edges[2] = edgeBetween(corner[third], corner[0]);
  return true;
}

} // namespace arbiter::swrast
