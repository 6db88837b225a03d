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

/// Begin/End deferred: the vertices of one primitive as they come. The generated
/// entry points of glVertex, glColor and their kin call set() and vertex() of ContextHot::recorder,
/// and the host where there is none.
namespace arbiter::state::software {

/// How many components each slot was given with, as bits: 1 << components. The others are the
/// defaults 0, 0, 1 (OpenGL 2.1, 2.7).
using GivenComponents = std::array<std::uint8_t, kSlots>;
/// The most that a slot was given with.
[[nodiscard]] inline int mostGiven(const GivenComponents &given, int slot) {
  return std::bit_width(unsigned(given[std::size_t(slot)])) - 1;
}

class ImmediateRecorder {
public:
  /// A primitive opens; attributes start as `current`, but for materials (setFirst()). There is no
  /// limit of its vertices.
  void begin(GLenum mode, const CurrentValues &current);
  /// Of what more vertices than a limit ask of: it makes room (forget()), or records no further and
  /// has taken the vertex at `position` by itself, and then returns false.
  using Full = bool (*)(void *owner, const float position[4]);
  /// From now on no more than `most` vertices are kept.
  void limit(std::uint32_t most, Full full, void *owner);
  void unlimit() { limit(kNoLimit, nullptr, nullptr); }
  /// Leaves out vertices [first, first + count). The others are numbered anew.
  void forget(std::uint32_t first, std::uint32_t count);
  /// Another primitive of the mode begins, of one whose vertices depend on each other (joined.h).
  /// Throws std::bad_alloc, and then it does not.
  void next() { m_starts.push_back(m_count); }
  /// The first vertices of the primitives behind the first one, by number.
  [[nodiscard]] std::span<const std::uint32_t> starts() const { return m_starts; }
  /// Vertices of the last primitive.
  [[nodiscard]] std::uint32_t lastCount() const {
    return m_count - (m_starts.empty() ? 0 : m_starts.back());
  }
  /// Leaves out all primitives but the last. Requires: starts() is not empty.
  void forgetEarlier();
  /// No more is recorded, and failed().
  void fail() { m_failed = true; }
  /// glColor, glTexCoord .. : all four components, defaults filled in behind those `given`.
  void set(int slot, float x, float y, float z, float w, unsigned given = 4) {
    if ((m_touched >> slot & 1u) == 0) [[unlikely]]
      touch(slot);
    m_given[std::size_t(slot)] |= std::uint8_t(1u << given);
    m_values[std::size_t(slot)] = {x, y, z, w};
  }
  /// glVertex, or glVertexAttrib of 0.
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
  /// Of a slot that begin() has no value of, and which was not touched: the vertices so far have
  /// this one.
  void setFirst(int slot, const std::array<float, 4> &value) {
    m_values[std::size_t(slot)] = value;
  }
  /// The primitive is whole. The source is valid until the next begin().
  [[nodiscard]] VertexSource end() const;

  [[nodiscard]] GLenum mode() const { return m_mode; }
  [[nodiscard]] std::uint32_t count() const { return m_count; }
  /// Slots that were set since begin(), one bit each, and the values now: what the host must be
  /// told.
  [[nodiscard]] SlotMask touched() const { return m_touched; }
  [[nodiscard]] const CurrentValues &values() const { return m_values; }
  /// Of the slots that were touched, and of the position.
  [[nodiscard]] const GivenComponents &given() const { return m_given; }
  /// Vertex `index` of those recorded: calls `set(slot, const float value[4])` of each slot that
  /// was touched before it, and then of kPosition.
  template <typename Set> void read(std::uint32_t index, Set &&set) const {
    const float *const from = m_data.get() + std::size_t(index) * m_stride;
    for (unsigned i = 1; i < m_slotCount; ++i)
      if (index >= m_since[m_slots[i]])
        set(int(m_slots[i]), from + 4 * i);
    set(int(kPosition), from);
  }
  /// A vertex is so many vec4s, one a slot: the position, then the touched ones in order of first
  /// use.
  [[nodiscard]] unsigned slotCount() const { return m_slotCount; }
  [[nodiscard]] const std::uint8_t *slots() const { return m_slots; }
  [[nodiscard]] std::uint8_t slot(unsigned i) const { return m_slots[i]; }
  /// How many vertices there were when the slot was first touched: these have the value of begin().
  [[nodiscard]] std::uint32_t since(int slot) const { return m_since[slot]; }
  [[nodiscard]] const float *data() const { return m_data.get(); }
  /// No memory was left: vertices are missing.
  [[nodiscard]] bool failed() const { return m_failed; }

private:
  static constexpr std::uint32_t kNoLimit = UINT32_MAX;
  struct Free {
    void operator()(float *data) const { std::free(data); }
  };
  /// The slot gets a place in each vertex; those that are there have the value of begin().
  void touch(int slot);
  [[nodiscard]] bool makeRoom(float x, float y, float z, float w);
  [[nodiscard]] bool reserve(std::size_t floats);
  void setEnd();

  GLenum m_mode = GL_POINTS;
  std::uint32_t m_count = 0;
  SlotMask m_touched = 0;
  bool m_failed = false;
  CurrentValues m_values{};
  /// Vertices, each `m_slotCount` vec4s: position first, then the touched slots in order of first
  /// use.
  std::unique_ptr<float[], Free> m_data;
  float *m_next = nullptr;
  float *m_end = nullptr;     ///< of the memory, or of what the limit leaves of it
  std::size_t m_capacity = 0; ///< floats
  std::uint32_t m_most = kNoLimit;
  Full m_full = nullptr;
  void *m_owner = nullptr;
  std::size_t m_stride = 4; ///< floats
  unsigned m_slotCount = 1;
  std::uint8_t m_slots[kSlots] = {};
  std::uint32_t m_since[kSlots] = {};
  GivenComponents m_given{};
  std::vector<std::uint32_t> m_starts;
};

} // namespace arbiter::state::software
