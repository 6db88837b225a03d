#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/vertices/draw_command.h"

#include "state/raster_draw/vertices/buffer_copies.h"

/// Vertex arrays and indices in memory, for the time of one draw.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {
struct Mirror;

/// Where the arrays of a draw lie: in client memory, in a copy of a buffer, or in a buffer that is
/// mapped from open() to close(), which must be called before the host draws. A draw like the one
/// before, of arrays that have not changed, looks at none of them.
class ArraySource {
public:
  /// Why open() refuses whatever is in the buffers: an array of a kind that we lack, or a primitive
  /// that restarts. The mirror's arrays are fresh.
  [[nodiscard]] static bool lacks(const Mirror &mirror, std::uint32_t slots,
                                  const DrawCommand &command);
  /// The arrays of `slots` and the indices of `command`. The mirror's arrays are fresh. False: an
  /// array is of a kind that we lack, a buffer cannot be mapped, or indices lie outside of theirs;
  /// the host draws.
  [[nodiscard]] bool open(Context &context, const Mirror &mirror, std::uint32_t slots,
                          const DrawCommand &command);
  void close(Context &context);

  /// VertexSource::count is set where a buffer's end is known.
  [[nodiscard]] const VertexSource &source() const { return m_source; }
  /// Null where the command has none.
  [[nodiscard]] const void *indices() const { return m_indices; }

private:
  struct Mapped {
    GLuint buffer = 0;
    BufferCopies::Contents contents;
    bool isApplications = false; ///< its own mapping, which stays
  };
  /// Null data: the buffer cannot be read.
  [[nodiscard]] BufferCopies::Contents contentsOf(Context &context, const Mirror &mirror,
                                                  GLuint buffer);
  /// Maps it until close(), or finds the application's own mapping.
  [[nodiscard]] BufferCopies::Contents map(Context &context, GLuint buffer);
  [[nodiscard]] bool addArrays(Context &context, const Mirror &mirror, std::uint32_t slots);
  [[nodiscard]] bool addIndices(Context &context, const Mirror &mirror, const DrawCommand &command);

  VertexSource m_source;
  std::uint32_t m_slots = 0; ///< that m_source has arrays of
  const void *m_indices = nullptr;
  BufferCopies m_copies;
  std::array<Mapped, kSlots + 1> m_mapped{};
  int m_mappedCount = 0;
  /// m_source holds for these slots, at this time of the clock, without a buffer that is mapped.
  bool m_kept = false;
  std::uint32_t m_keptSlots = 0;
  std::uint64_t m_seen = 0;
};

} // namespace arbiter::state::software
