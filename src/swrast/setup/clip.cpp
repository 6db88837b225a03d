#include "swrast/setup/clip.h"

#include <algorithm>
#include <cmath>

namespace arbiter::swrast {
namespace {

/// A clip plane: a position is inside if the sum of the products is not negative.
struct Plane {
  float x, y, z, w, constant;
  int user; ///< number of a clip distance, or -1
};

/// Returns a lower limit of w that keeps 1/w, and its products, finite.
float smallestW(const ClipVertex *vertex, int count) {
  float largest = 0;
  for (int i = 0; i < count; ++i)
    largest = std::max(largest, std::fabs(vertex[i].position[3]));
  return std::max(largest * 0x1p-20f, 0x1p-100f);
}

/// Lists the clip planes. Their order is the hosts', so that a corner cut by two planes matches.
int planesOf(const Viewport &viewport, float smallest, Plane planes[16]) {
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

float distanceOf(const Plane &plane, const ClipVertex &vertex) {
  if (plane.user >= 0)
    return vertex.user[plane.user];
  const float *const p = vertex.position;
  return plane.x * p[0] + plane.y * p[1] + plane.z * p[2] + plane.w * p[3] + plane.constant;
}

/// Computes the vertex where a side crosses a plane. It always starts from the end that is nearer
/// to the plane, so that two triangles cut a common side alike. It uses single precision as hosts
/// do, so that depths are equal to the last bit.
void between(const ClipVertex &inside, const ClipVertex &outside, float inner, float outer,
             bool userPlanes, Cuts &cuts, ClipVertex &result) {
  // A distance may be NaN, which counts as outside.
  const bool fromOutside = -outer < inner;
  const ClipVertex &near = fromOutside ? outside : inside;
  const ClipVertex &far = fromOutside ? inside : outside;
  const float ratio = fromOutside ? outer / (outer - inner) : inner / (inner - outer);
  const float t = ratio > 0 ? ratio : 0;
  const auto mix = [t](float a, float b) { return a + t * (b - a); };
  for (int i = 0; i < 4; ++i)
    result.position[i] = mix(near.position[i], far.position[i]);
  result.place = cuts.add(near.place, far.place, t);
  if (userPlanes)
    for (int i = 0; i < 8; ++i)
      result.user[i] = mix(near.user[i], far.user[i]);
  result.window.outcode = kOutW; // marks that the window position is still to be computed
  result.side = 0;
}

void takeOriginal(const Viewport &viewport, const Vertices &vertices, std::uint32_t index,
                  const WindowVertex &window, int which, ClipVertex &result) {
  for (int i = 0; i < 4; ++i)
    result.position[i] = vertices.position[i][index];
  result.place = std::uint8_t(which);
  result.side = which;
  if (viewport.userPlanes != 0)
    for (int i = 0; i < 8; ++i)
      result.user[i] = vertices.clipDistance[i] ? vertices.clipDistance[i][index] : 0;
  result.window = window;
}

void finish(const Viewport &viewport, ClipVertex &vertex) {
  if (!(vertex.window.outcode & kOutW))
    return; // an original vertex, placed as in the other triangles that use it
  cutToWindow(viewport, vertex.position, vertex.window);
}

} // namespace

void clipTriangle(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[3],
                  const WindowVertex corner[3], ClippedPolygon &polygon) {
  const bool userPlanes = viewport.userPlanes != 0;
  ClippedPolygon other;
  Cuts &cuts = polygon.cuts;
  ClippedPolygon *in = &polygon, *out = &other;
  for (int i = 0; i < 3; ++i)
    takeOriginal(viewport, vertices, index[i], corner[i], i, in->vertex[std::size_t(i)]);
  in->count = 3;
  Plane planes[16];
  const int planeCount = planesOf(viewport, smallestW(in->vertex.data(), 3), planes);
  for (int p = 0; p < planeCount; ++p) {
    float distance[20];
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
      if (aInside)
        between(a, b, distance[i], distance[next], userPlanes, cuts, cut);
      else
        between(b, a, distance[next], distance[i], userPlanes, cuts, cut);
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
  if (in == &polygon)
    return;
  polygon.count = in->count;
  std::copy_n(in->vertex.begin(), in->count, polygon.vertex.begin());
}

bool hasTwins(const Vertices &vertices, const std::uint32_t index[3]) {
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    const float *const *const position = vertices.position;
    return position[0][a] == position[0][b] && position[1][a] == position[1][b] &&
           position[2][a] == position[2][b] && position[3][a] == position[3][b];
  };
  return same(index[0], index[1]) || same(index[1], index[2]) || same(index[2], index[0]);
}

/// Moves each end along the whole line, by the largest share that a plane demands, as hosts do.
bool clipLine(const Viewport &viewport, const Vertices &vertices, const std::uint32_t index[2],
              const WindowVertex corner[2], ClipVertex end[2], Cuts &cuts) {
  ClipVertex original[2];
  for (int i = 0; i < 2; ++i)
    takeOriginal(viewport, vertices, index[i], corner[i], i, original[i]);
  Plane planes[16];
  const int planeCount = planesOf(viewport, smallestW(original, 2), planes);
  float share[2] = {0, 0};
  for (int p = 0; p < planeCount; ++p) {
    const float distance[2] = {distanceOf(planes[p], original[0]),
                               distanceOf(planes[p], original[1])};
    if (!(distance[0] >= 0) && !(distance[1] >= 0))
      return false;
    for (int i = 0; i < 2; ++i) {
      if (distance[i] >= 0)
        continue;
      const float wanted = distance[i] / (distance[i] - distance[1 - i]);
      if (!(wanted <= 1)) // wanted may be NaN
        return false;
      share[i] = std::max(share[i], wanted);
    }
    if (share[0] + share[1] >= 1)
      return false;
  }
  for (int i = 0; i < 2; ++i) {
    const ClipVertex &own = original[i], &other = original[1 - i];
    end[i] = own;
    if (share[i] == 0)
      continue;
    for (int c = 0; c < 4; ++c)
      end[i].position[c] = own.position[c] + share[i] * (other.position[c] - own.position[c]);
    end[i].place = cuts.add(own.place, other.place, share[i]);
    cutToWindow(viewport, end[i].position, end[i].window);
  }
  return true;
}

} // namespace arbiter::swrast
