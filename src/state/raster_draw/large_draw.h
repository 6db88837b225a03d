#pragma once
#include <cstdint>

#include "state/raster_draw/outcome.h"
#include "state/raster_draw/pipeline.h"

/// Draws of so many vertices that arrays for all of them at once would be most of the process's
/// memory: drawn in parts, each with what its primitives share with the part before.
namespace arbiter::state::software {

/// The sequence of vertices of a draw: `count` of them from `first` on, or (type not 0) those that
/// `count` indices name, with `baseVertex` added.
struct VertexSequence {
  std::uint32_t first = 0, count = 0;
  GLenum indexType = 0;
  const void *indices = nullptr;
  std::int32_t baseVertex = 0;
};

/// Vertices at once; more take more memory than they are worth.
inline constexpr std::uint32_t kMostAtOnce = 1u << 18;

/// Vertices that a primitive is recorded to once parts of it have been drawn.
inline constexpr std::uint32_t kMostOpen = 1u << 14;

/// Whether a draw goes in parts, as far as its counts say. Indices mostly name vertices many times,
/// which are worth transforming once.
[[nodiscard]] constexpr bool isLarge(const VertexSequence &sequence) {
  return sequence.count > (sequence.indexType != 0 ? 4 * kMostAtOnce : kMostAtOnce);
}
/// Whether it does for what the indices name.
[[nodiscard]] constexpr bool isLarge(const IndexRange &range) {
  return range.count > kMostAtOnce && range.maximum - range.minimum >= kMostAtOnce;
}

/// Not ok: nothing has been drawn, and the host must. Throws std::bad_alloc where memory runs out
/// after the first part.
Outcome drawInParts(Context &context, Pipeline &pipeline, const VertexSource &source,
                    const VertexSequence &sequence);

/// How much of a primitive that is still open is drawn before its other vertices are there.
struct OpenPart {
  std::uint32_t drawn = 0; ///< of its first vertices
  /// Of those the ones that what follows does not need any more: [kept, kept + done).
  std::uint32_t kept = 0, done = 0;
};
/// Whether primitives of the chosen draw may be drawn so.
[[nodiscard]] bool opensInParts(const Context &context, const Pipeline &pipeline);
/// Of `count` vertices: as many parts as are full. What is left, and what follows, is drawn by
/// drawInParts() in the parts that the whole primitive would have.
[[nodiscard]] OpenPart openPart(const Pipeline &pipeline, std::uint32_t count);

} // namespace arbiter::state::software
