#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "swrast/cover/chunk.h"
#include "swrast/queue/queued_state.h"
#include "swrast/setup/draw.h"

/// A draw in the queue.
namespace arbiter::swrast {

/// A draw that has been set up, or that keeps what setup needs. Objects are reused, so that
/// repeated draws allocate nothing.
class QueuedDraw {
public:
  /// For delayed setup: number of triangles that a thread sets up at a time.
  static constexpr std::uint32_t kChunkTriangles = 1024;

  QueuedDraw() : m_chunks(1) {}
  QueuedDraw(const QueuedDraw &) = delete;
  QueuedDraw &operator=(const QueuedDraw &) = delete;

  /// Returns the window positions of the draw's vertices.
  [[nodiscard]] std::vector<WindowVertex> &window() { return m_window; }
  /// Begins a draw with one chunk, which the caller sets up.
  [[nodiscard]] Chunk &begin() {
    m_count = 1;
    return m_chunks[0];
  }
  /// Copies the vertices' inputs that shading needs. May throw std::bad_alloc.
  void keepInputs(const PlanePlan &plan, std::uint32_t vertices);
  /// Begins a draw that setUp() will set up, and copies what that needs. Requires that no vertex is
  /// clipped. May throw std::bad_alloc.
  void keep(const Draw &draw, std::uint32_t triangles);
  /// Sets the draw's state, which must live as long as the draw waits.
  void setState(const QueuedState &state) { m_state = &state; }
  /// Sets up a chunk of a kept draw. Threads may set up different chunks at the same time.
  void setUp(std::uint32_t chunk);

  /// Returns the bytes that the draw keeps allocated.
  [[nodiscard]] std::size_t bytes() const;
  void free();

  [[nodiscard]] const QueuedState *state() const { return m_state; }
  [[nodiscard]] std::uint32_t chunkCount() const { return m_count; }
  [[nodiscard]] const Chunk &chunk(std::uint32_t number) const { return m_chunks[number]; }
  void shade(std::uint32_t chunk, std::uint32_t tile, const Rect &rect, Emitter &emitter) const {
    m_chunks[chunk].shade(tile, m_plan, m_window.data(), rect, emitter);
  }

private:
  const QueuedState *m_state = nullptr;
  std::vector<Chunk> m_chunks; ///< at least one
  std::uint32_t m_count = 0;   ///< number of chunks in use
  std::vector<WindowVertex> m_window;
  std::vector<float> m_values; ///< copies of the vertices' inputs
  PlanePlan m_plan;            ///< refers to m_values
  // Set by keep().
  std::vector<std::uint32_t> m_indices;
  Topology m_topology = Topology::Triangles;
  std::uint32_t m_first = 0, m_vertexCount = 0, m_allVertices = 0, m_triangles = 0;
  bool m_isIndexed = false, m_otherDiagonal = false;
  Viewport m_viewport;
  Rect m_bounds, m_visible;
};

} // namespace arbiter::swrast
