#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

#include "state/software/attributes.h"
#include "state/software/draw.h"

/// Vertex arrays and indices in memory, for the time of one draw.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {
struct Mirror;

/// Maps the buffers that the arrays of `slots` and the indices of `command` lie in; they are
/// unmapped when this goes, which must be before the host draws. The mirror's arrays are fresh.
class ArraySource {
public:
  ArraySource(Context &context, const Mirror &mirror, std::uint32_t slots,
              const DrawCommand &command);
  ~ArraySource();
  ArraySource(const ArraySource &) = delete;
  ArraySource &operator=(const ArraySource &) = delete;

  /// False: an array is of a kind that we lack, a buffer cannot be mapped, or indices lie outside
  /// of theirs; the host draws.
  [[nodiscard]] bool valid() const { return m_valid; }
  /// VertexSource::count is set where a buffer's end is known.
  [[nodiscard]] const VertexSource &source() const { return m_source; }
  /// Null where the command has none.
  [[nodiscard]] const void *indices() const { return m_indices; }

private:
  struct Mapped {
    GLuint buffer = 0;
    const std::uint8_t *data = nullptr;
    std::size_t bytes = 0;
  };
  [[nodiscard]] const Mapped *map(GLuint buffer);
  [[nodiscard]] bool addArrays(const Mirror &mirror, std::uint32_t slots);
  [[nodiscard]] bool addIndices(const Mirror &mirror, const DrawCommand &command);

  Context &m_context;
  VertexSource m_source;
  const void *m_indices = nullptr;
  bool m_valid = false;
  std::array<Mapped, kSlots + 1> m_mapped{};
  int m_mappedCount = 0;
};

} // namespace arbiter::state::software
