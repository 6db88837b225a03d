#include "swrast/queue/queued_draw.h"

#include <algorithm>
#include <cstring>

namespace arbiter::swrast {
namespace {

/// Copies a plan without its unused sources.
void copyPlan(PlanePlan &to, const PlanePlan &from) {
  to.linearFrom = from.linearFrom;
  to.flatFrom = from.flatFrom;
  to.count = from.count;
  to.wantsDepth = from.wantsDepth;
  to.wantsW = from.wantsW;
  std::copy_n(from.sources, from.count, to.sources);
}

} // namespace

void QueuedDraw::keepInputs(const PlanePlan &plan, std::uint32_t vertices) {
  copyPlan(m_plan, plan);
  const auto isOneArray = [](const PlanePlan::Source &source) {
    return source.values[0] == source.values[1];
  };
  std::size_t arrays = 0;
  for (int i = 0; i < plan.count; ++i)
    arrays += isOneArray(plan.sources[i]) ? 1 : 2;
  m_values.resize(arrays * vertices);
  float *next = m_values.data();
  for (int i = 0; i < plan.count; ++i)
    for (int face = 0; face < 2; ++face) {
      PlanePlan::Source &own = m_plan.sources[i];
      if (own.mask[face] == 0)
        continue; // a constant
      if (face == 1 && isOneArray(plan.sources[i])) {
        own.values[1] = own.values[0];
        continue;
      }
      std::memcpy(next, own.values[face], vertices * sizeof *next);
      own.values[face] = next;
      next += vertices;
    }
}

void QueuedDraw::keep(const Draw &draw, std::uint32_t triangles) {
  keepInputs(draw.plan, draw.vertices.count);
  m_isIndexed = draw.indices != nullptr;
  if (m_isIndexed)
    m_indices.assign(draw.indices, draw.indices + draw.count);
  m_topology = draw.topology;
  m_first = draw.first;
  m_vertexCount = draw.count;
  m_allVertices = draw.vertices.count;
  m_triangles = triangles;
  m_otherDiagonal = draw.otherDiagonal;
  m_viewport = draw.viewport;
  m_visible = draw.visible;
  m_bounds = draw.bounds;
  m_count = (triangles + kChunkTriangles - 1) / kChunkTriangles;
  if (m_chunks.size() < m_count)
    m_chunks.resize(m_count);
  const TileGrid grid = TileGrid::of(m_visible, m_bounds);
  for (std::uint32_t i = 0; i < m_count; ++i)
    m_chunks[i].clear(grid);
}

std::size_t QueuedDraw::bytes() const {
  std::size_t bytes = m_window.capacity() * sizeof m_window[0] +
                      m_values.capacity() * sizeof m_values[0] +
                      m_indices.capacity() * sizeof m_indices[0];
  for (const Chunk &chunk : m_chunks)
    bytes += chunk.bytes();
  return bytes;
}

void QueuedDraw::free() {
  for (Chunk &chunk : m_chunks)
    chunk = {};
  m_window = {};
  m_values = {};
  m_indices = {};
}

void QueuedDraw::setUp(std::uint32_t chunk) {
  Vertices vertices; // setup without clipping reads no vertex array
  vertices.count = m_allVertices;
  Draw draw = {{m_state->raster(), m_state->shading(), m_topology, vertices,
                m_isIndexed ? m_indices.data() : nullptr, m_first, m_vertexCount},
               m_viewport,
               {},
               m_window.data(),
               m_bounds,
               m_visible,
               m_otherDiagonal,
               false};
  copyPlan(draw.plan, m_plan);
  const std::uint32_t begin = chunk * kChunkTriangles;
  m_chunks[chunk].setUp(draw, begin, std::min(m_triangles, begin + kChunkTriangles));
}

} // namespace arbiter::swrast
