#pragma once
#include <cstdint>

#include "state/raster_draw/outcome.h"
#include "state/raster_draw/pipeline.h"

/// Draws with very many vertices, whose arrays would use most of the process's memory. They are
/// drawn in parts, and each part repeats the vertices that it shares with the part before.
namespace arbiter::state {

/// The vertices of a draw: `count` of them from `first` on, or, if the type is not 0, those that
/// `count` indices name, plus `baseVertex`.
struct VertexSequence {
  std::uint32_t first = 0, count = 0;
  GLenum indexType = 0;
  const void *indices = nullptr;
  std::int32_t baseVertex = 0;
};

/// Most vertices to draw at once; more would waste memory.
inline constexpr std::uint32_t kMaxAtOnce = 1u << 18;

/// Most vertices in the recorder after parts of an open primitive have been drawn.
inline constexpr std::uint32_t kMaxOpen = 1u << 14;

/// True if a draw must be split, as far as counts tell. Indices may be four times as many, because
/// they mostly repeat vertices, which should be transformed once.
[[nodiscard]] constexpr bool isLarge(const VertexSequence &sequence) {
  return sequence.count > (sequence.indexType != 0 ? 4 * kMaxAtOnce : kMaxAtOnce);
}
/// True if a draw must be split, by the range of its indices.
[[nodiscard]] constexpr bool isLarge(const IndexRange &range) {
  return range.count > kMaxAtOnce && range.maximum - range.minimum >= kMaxAtOnce;
}

/// Draws the sequence in parts. If the outcome is not ok, nothing has been drawn and the host must
/// draw. Throws std::bad_alloc if memory runs out after the first part.
Outcome drawInParts(RasterContext &context, Pipeline &pipeline, const VertexSource &source,
                    const VertexSequence &sequence);

/// The part of an open primitive that is drawn before its remaining vertices exist.
struct OpenPart {
  std::uint32_t drawn = 0; ///< number of vertices drawn
  /// Drawn vertices that are no longer needed: [kept, kept + done).
  std::uint32_t kept = 0, done = 0;
};
/// True if open primitives of the chosen draw may be drawn in parts.
[[nodiscard]] bool opensInParts(const RasterContext &context, const Pipeline &pipeline);
/// Returns the full parts among the first `count` vertices. drawInParts() later draws the rest in
/// the parts that the whole primitive would have had.
[[nodiscard]] OpenPart openPart(const Pipeline &pipeline, std::uint32_t count);

} // namespace arbiter::state
