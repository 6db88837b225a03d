#pragma once
#include <cstdint>

#include "state/software/outcome.h"
#include "state/software/pipeline.h"

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

} // namespace arbiter::state::software
