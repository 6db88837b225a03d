#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/raster_draw/vertices/draw_command.h"

#include "state/raster_draw/vertices/buffer_copies.h"

/// Finds a draw's vertex arrays and indices in memory.
namespace arbiter::state {
class Mirror;
struct RasterContext;

/// The arrays of a draw: in client memory, in a copy of a buffer, or in a buffer that is mapped
/// from open() to close(). close() must be called before the host draws. If a draw repeats the last
/// one and no array has changed, no array is looked at.
class ArraySource {
public:
  /// True if open() would fail whatever the buffers contain: an array type that the rasterizer
  /// lacks, or primitive restart. Requires that the mirror's arrays are up to date.
  [[nodiscard]] static bool lacks(const Mirror &mirror, std::uint32_t slots,
                                  const DrawCommand &command);
  /// Opens the arrays of `slots` and the indices of `command`. Returns false if the host must draw:
  /// an array type is not supported, a buffer cannot be mapped, or indices lie outside of their
  /// buffer. Requires that the mirror's arrays are up to date.
  [[nodiscard]] bool open(RasterContext &context, const Mirror &mirror, std::uint32_t slots,
                          const DrawCommand &command);
  void close(RasterContext &context);

  /// Returns the arrays. VertexSource::count is set if a buffer's end is known.
  [[nodiscard]] const VertexSource &source() const { return m_source; }
  /// Returns the indices, or null if the command has none.
  [[nodiscard]] const void *indices() const { return m_indices; }

private:
  struct Mapped {
    GLuint buffer = 0;
    BufferCopies::Contents contents;
    bool isApplications = false; ///< true if the application mapped it, so that it stays mapped
  };
  /// Returns a buffer's contents; data is null if it cannot be read.
  [[nodiscard]] BufferCopies::Contents contentsOf(RasterContext &context, const Mirror &mirror,
                                                  GLuint buffer);
  /// Maps a buffer until close(), or finds the application's own mapping.
  [[nodiscard]] BufferCopies::Contents map(RasterContext &context, GLuint buffer);
  [[nodiscard]] bool addArrays(RasterContext &context, const Mirror &mirror, std::uint32_t slots);
  [[nodiscard]] bool addIndices(RasterContext &context, const Mirror &mirror,
                                const DrawCommand &command);

  VertexSource m_source;
  std::uint32_t m_slots = 0; ///< slots whose arrays are in m_source
  const void *m_indices = nullptr;
  BufferCopies m_copies;
  std::array<Mapped, kSlots + 1> m_mapped{};
  int m_mappedCount = 0;
  /// True if m_source is valid for these slots at this clock value, and uses no mapped buffer.
  bool m_kept = false;
  std::uint32_t m_keptSlots = 0;
  std::uint64_t m_seen = 0;
};

} // namespace arbiter::state
