#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "swrast/cover/chunk.h"
#include "swrast/queue/queued_state.h"
#include "swrast/setup/draw.h"

/// One draw that waits.
namespace arbiter::swrast {

/// A draw that is set up, or has all that it takes to be. Used again for other draws, so that one
/// like the last one allocates nothing.
class QueuedDraw {
public:
  /// Of draws that are set up later: triangles that a thread sets up at a time.
  static constexpr std::uint32_t kChunkTriangles = 1024;

  QueuedDraw() : m_chunks(1) {}
  QueuedDraw(const QueuedDraw &) = delete;
  QueuedDraw &operator=(const QueuedDraw &) = delete;

  /// Where window positions of the draw's vertices lie.
  [[nodiscard]] std::vector<WindowVertex> &window() { return m_window; }
  /// Begins a draw with one chunk, which the caller sets up.
  [[nodiscard]] Chunk &begin() {
    m_count = 1;
    return m_chunks[0];
  }
  /// Keeps what tiles need of the vertices' inputs. Throws std::bad_alloc.
  void keepInputs(const PlanePlan &plan, std::uint32_t vertices);
  /// Begins a draw that setUp() sets up, and keeps what that needs. No vertex of it is clipped.
  /// Throws std::bad_alloc.
  void keep(const Draw &draw, std::uint32_t triangles);
  /// What it is drawn with, which lives as long as the draw waits.
  void setState(const QueuedState &state) { m_state = &state; }
  /// Sets up a chunk of a kept draw. Threads may set up different ones at a time.
  void setUp(std::uint32_t chunk);

  /// That it keeps.
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
  std::vector<Chunk> m_chunks; ///< one at least
  std::uint32_t m_count = 0;   ///< of the draw
  std::vector<WindowVertex> m_window;
  std::vector<float> m_values; ///< of the vertices' inputs
  PlanePlan m_plan;            ///< over m_values
  // Of a draw that was kept.
  std::vector<std::uint32_t> m_indices;
  Topology m_topology = Topology::Triangles;
  std::uint32_t m_first = 0, m_vertexCount = 0, m_allVertices = 0, m_triangles = 0;
  bool m_isIndexed = false, m_otherDiagonal = false;
  Viewport m_viewport;
  Rect m_bounds, m_visible;
};

} // namespace arbiter::swrast
