#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include <GL/gl.h>

#include "state/mirror/attributes.h"

/// Records the vertices of a primitive between Begin and End. The generated entry points of
/// glVertex, glColor and so on call set() and vertex() of ContextHot::recorder, or the host if it
/// is null.
namespace arbiter::state {

/// The numbers of components with which each slot was given, as bits: 1 << components. The other
/// components have the defaults 0, 0, 1 (OpenGL 2.1, 2.7).
using GivenComponents = std::array<std::uint8_t, kSlots>;
/// Returns the largest number of components that a slot was given with.
[[nodiscard]] inline int mostGiven(const GivenComponents &given, int slot) {
  return int(std::bit_width(unsigned(given[std::size_t(slot)]))) - 1;
}

class ImmediateRecorder {
public:
  /// Begins a primitive without a limit of vertices. Attributes start with the values of `current`,
  /// except materials (setFirst()).
  void begin(GLenum mode, const CurrentValues &current);
  /// Called when the recorder has reached its limit. It makes room by forget() and returns true. Or
  /// it stops recording, handles the vertex at `position` itself, and returns false.
  using Full = bool (*)(void *owner, const float position[4]);
  /// Limits the recorder to `most` vertices from now on.
  void limit(std::uint32_t most, Full full, void *owner);
  void unlimit() { limit(kNoLimit, nullptr, nullptr); }
  /// Removes vertices [first, first + count), and renumbers the others.
  void forget(std::uint32_t first, std::uint32_t count);
  /// Begins another primitive of a mode whose vertices depend on each other (joined.h). Throws
  /// std::bad_alloc, and then changes nothing.
  void next() { m_starts.push_back(m_count); }
  /// Returns the first vertices of all primitives but the first one.
  [[nodiscard]] std::span<const std::uint32_t> starts() const { return m_starts; }
  /// Returns the number of vertices of the last primitive.
  [[nodiscard]] std::uint32_t lastCount() const {
    return m_count - (m_starts.empty() ? 0 : m_starts.back());
  }
  /// Removes all primitives but the last. Requires that starts() is not empty.
  void forgetEarlier();
  /// Makes failed() true; nothing more is recorded.
  void fail() { m_failed = true; }
  /// Sets an attribute (glColor, glTexCoord, ...). All four components are passed; those behind the
  /// `given` ones are defaults.
  void set(int slot, float x, float y, float z, float w, unsigned given = 4) {
    if ((m_touched >> slot & 1u) == 0) [[unlikely]]
      touch(slot);
    m_given[std::size_t(slot)] |= std::uint8_t(1u << given);
    m_values[std::size_t(slot)] = {x, y, z, w};
  }
  /// Adds a vertex: glVertex, or glVertexAttrib of 0.
  void vertex(float x, float y, float z, float w, unsigned given = 4) {
    m_given[kPosition] |= std::uint8_t(1u << given);
    if (m_next + m_stride > m_end && !makeRoom(x, y, z, w)) [[unlikely]]
      return;
    float *to = m_next;
    m_next += m_stride;
    ++m_count;
    to[0] = x;
    to[1] = y;
    to[2] = z;
    to[3] = w;
    for (unsigned i = 1; i < m_slotCount; ++i)
      __builtin_memcpy(to += 4, &m_values[m_slots[i]], 4 * sizeof(float));
  }
  /// Sets the value of a slot for which begin() had none, for all vertices so far. Requires that
  /// the slot was not touched.
  void setFirst(int slot, const std::array<float, 4> &value) {
    m_values[std::size_t(slot)] = value;
  }
  /// Ends the primitive and returns its vertices, valid until the next begin().
  [[nodiscard]] VertexSource end() const;

  [[nodiscard]] GLenum mode() const { return m_mode; }
  [[nodiscard]] std::uint32_t count() const { return m_count; }
  /// Returns the slots set since begin(), one bit for each. The host must be given their values.
  [[nodiscard]] SlotMask touched() const { return m_touched; }
  [[nodiscard]] const CurrentValues &values() const { return m_values; }
  /// Returns the component counts of the touched slots and of the position.
  [[nodiscard]] const GivenComponents &given() const { return m_given; }
  /// Reads vertex `index`: calls `set(slot, const float value[4])` for each slot that was touched
  /// before it, and then for kPosition.
  template <typename Set> void read(std::uint32_t index, Set &&set) const {
    const float *const from = m_data.get() + std::size_t(index) * m_stride;
    for (unsigned i = 1; i < m_slotCount; ++i)
      if (index >= m_since[m_slots[i]])
        set(int(m_slots[i]), from + 4 * i);
    set(int(kPosition), from);
  }
  /// Returns the number of vec4s in a vertex, one for each slot: the position, then the touched
  /// slots in order of first use.
  [[nodiscard]] unsigned slotCount() const { return m_slotCount; }
  [[nodiscard]] const std::uint8_t *slots() const { return m_slots; }
  [[nodiscard]] std::uint8_t slot(unsigned i) const { return m_slots[i]; }
  /// Returns the number of vertices before the slot was first touched; these have the value of
  /// begin().
  [[nodiscard]] std::uint32_t since(int slot) const { return m_since[slot]; }
  [[nodiscard]] const float *data() const { return m_data.get(); }
  /// True if vertices are missing for lack of memory.
  [[nodiscard]] bool failed() const { return m_failed; }

private:
  static constexpr std::uint32_t kNoLimit = UINT32_MAX;
  struct Free {
    void operator()(float *data) const { std::free(data); }
  };
  /// Adds a slot to each vertex. Existing vertices get the value of begin().
  void touch(int slot);
  [[nodiscard]] bool makeRoom(float x, float y, float z, float w);
  [[nodiscard]] bool reserve(std::size_t floats);
  void setEnd();

  GLenum m_mode = GL_POINTS;
  std::uint32_t m_count = 0;
  SlotMask m_touched = 0;
  bool m_failed = false;
  CurrentValues m_values{};
  /// Vertices of `m_slotCount` vec4s each: the position, then the touched slots in order of first
  /// use.
  std::unique_ptr<float[], Free> m_data;
  float *m_next = nullptr;
  float *m_end = nullptr;     ///< end of the memory, or of the part that the limit allows
  std::size_t m_capacity = 0; ///< in floats
  std::uint32_t m_most = kNoLimit;
  Full m_full = nullptr;
  void *m_owner = nullptr;
  std::size_t m_stride = 4; ///< in floats
  unsigned m_slotCount = 1;
  std::uint8_t m_slots[kSlots] = {};
  std::uint32_t m_since[kSlots] = {};
  GivenComponents m_given{};
  std::vector<std::uint32_t> m_starts;
};

} // namespace arbiter::state
