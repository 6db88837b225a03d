#include "swrast/clip.h"

#include <algorithm>
#include <cmath>

namespace arbiter::swrast {
namespace {

/// Inside where the sum of products is not negative.
struct Plane {
  double x, y, z, w, constant;
  int user; ///< a clip distance, or -1
};

/// w no smaller than this keeps 1/w and what it multiplies finite.
double smallestW(const ClipVertex *vertex, int count) {
  double largest = 0;
  for (int i = 0; i < count; ++i)
    largest = std::max(largest, std::fabs(vertex[i].position[3]));
  return std::max(largest * 0x1p-20, 0x1p-100);
}

/// In the order of hosts, so that what is cut twice is cut alike.
int planesOf(const Viewport &viewport, double smallest, Plane planes[16]) {
  int count = 0;
  planes[count++] = {-1, 0, 0, 1, 0, -1};
  planes[count++] = {1, 0, 0, 1, 0, -1};
  planes[count++] = {0, -1, 0, 1, 0, -1};
  planes[count++] = {0, 1, 0, 1, 0, -1};
  if (!viewport.depthClamp) {
    planes[count++] = {0, 0, 1, 1, 0, -1};
    planes[count++] = {0, 0, -1, 1, 0, -1};
  }
  for (int user = 0; user < 8; ++user)
    if ((viewport.userPlanes >> user) & 1u)
      planes[count++] = {0, 0, 0, 0, 0, user};
  planes[count++] = {0, 0, 0, 1, -smallest, -1};
  return count;
}

double distanceOf(const Plane &plane, const ClipVertex &vertex) {
  if (plane.user >= 0)
    return vertex.user[plane.user];
  const double *const p = vertex.position;
  return plane.x * p[0] + plane.y * p[1] + plane.z * p[2] + plane.w * p[3] + plane.constant;
}

/// Always from the inside to the outside, so that two triangles cut their common side alike.
ClipVertex between(const ClipVertex &inside, const ClipVertex &outside, double inner,
                   double outer) {
  const double t = inner / (inner - outer);
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  ClipVertex result;
  for (int i = 0; i < 4; ++i)
    result.position[i] = mix(inside.position[i], outside.position[i]);
  for (int i = 0; i < 3; ++i)
    result.weight[i] = mix(inside.weight[i], outside.weight[i]);
  for (int i = 0; i < 8; ++i)
    result.user[i] = mix(inside.user[i], outside.user[i]);
  result.window.outcode = kOutW; // its window position is still to be made
  result.side = 0;
  return result;
}

ClipVertex original(const Viewport &viewport, const Vertices &vertices, std::uint32_t index,
                    int which) {
  ClipVertex result{};
  for (int i = 0; i < 4; ++i)
    result.position[i] = vertices.position[i][index];
  result.weight[which] = 1;
  result.side = which;
  for (int i = 0; i < 8; ++i)
    result.user[i] = vertices.clipDistance[i] ? vertices.clipDistance[i][index] : 0;
  result.window = windowVertex(viewport, vertices, index);
  return result;
}

void finish(const Viewport &viewport, ClipVertex &vertex) {
  if (!(vertex.window.outcode & kOutW))
    return; // an original, to be placed as in its other triangles
  const float clip[4] = {float(vertex.position[0]), float(vertex.position[1]),
                         float(vertex.position[2]), float(vertex.position[3])};
  toWindow(viewport, clip, vertex.window);
}

} // namespace

void clipTriangle(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[3],
                  ClippedPolygon &polygon) {
  ClippedPolygon other;
  ClippedPolygon *in = &polygon, *out = &other;
  for (int i = 0; i < 3; ++i)
    in->vertex[std::size_t(i)] = original(viewport, vertices, index[i], i);
  in->count = 3;
  Plane planes[16];
  const int planeCount = planesOf(viewport, smallestW(in->vertex.data(), 3), planes);
  for (int p = 0; p < planeCount; ++p) {
    double distance[20] = {};
    bool allInside = true;
    for (int i = 0; i < in->count; ++i) {
      distance[i] = distanceOf(planes[p], in->vertex[std::size_t(i)]);
      allInside = allInside && distance[i] >= 0;
    }
    if (allInside)
      continue;
    out->count = 0;
    for (int i = 0; i < in->count; ++i) {
      const int next = i + 1 == in->count ? 0 : i + 1;
      const ClipVertex &a = in->vertex[std::size_t(i)], &b = in->vertex[std::size_t(next)];
      const bool aInside = distance[i] >= 0, bInside = distance[next] >= 0;
      if (aInside)
        out->vertex[std::size_t(out->count++)] = a;
      if (aInside == bInside)
        continue;
      ClipVertex &cut = out->vertex[std::size_t(out->count++)];
      cut = aInside ? between(a, b, distance[i], distance[next])
                    : between(b, a, distance[next], distance[i]);
      cut.side = !aInside ? a.side : planes[p].user >= 0 ? kOnUserPlane : kOnPlane + p;
    }
    std::swap(in, out);
    if (in->count < 3)
      break;
  }
  if (in->count < 3) {
    polygon.count = 0;
    return;
  }
  for (int i = 0; i < in->count; ++i)
    finish(viewport, in->vertex[std::size_t(i)]);
  if (in != &polygon)
    polygon = *in;
}

bool clipLine(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[2],
              ClipVertex end[2]) {
  for (int i = 0; i < 2; ++i)
    end[i] = original(viewport, vertices, index[i], i);
  Plane planes[16];
  const int planeCount = planesOf(viewport, smallestW(end, 2), planes);
  for (int p = 0; p < planeCount; ++p) {
    const double first = distanceOf(planes[p], end[0]), second = distanceOf(planes[p], end[1]);
    if (!(first >= 0) && !(second >= 0))
      return false;
    if (!(first >= 0))
      end[0] = between(end[1], end[0], second, first);
    else if (!(second >= 0))
      end[1] = between(end[0], end[1], first, second);
  }
  finish(viewport, end[0]);
  finish(viewport, end[1]);
  return true;
}

} // namespace arbiter::swrast
