#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include <GL/gl.h>

#include "state/mirror/attributes.h"
#include "state/primitives/recorder.h"

/// Primitives in a display list (OpenGL 1.4, 5.4) as the application gave them. Their vertices stay
/// in memory from call to call.
namespace arbiter::state {

/// Returns the number of vertices of a primitive if primitives of this mode share none, so that
/// several form one. Returns 0 for all other modes.
[[nodiscard]] std::uint32_t independentVertices(GLenum mode);

/// One or more primitives of one mode, or the beginning of one. A list may leave a primitive open,
/// or continue it with a command that is no vertex (CallList). If an attribute was not set in the
/// list before a vertex, the vertex has the value that is current when the list is called.
class Geometry {
public:
  GLenum mode = GL_POINTS;
  std::uint32_t count = 0;  ///< number of vertices
  std::vector<float> data;  ///< `count` times `stride` floats
  std::uint32_t stride = 4; ///< floats of a vertex: a vec4 for each of `slots`, the position first
  std::uint32_t slotCount = 1;
  std::array<std::uint8_t, kSlots> slots{};
  /// For each of `slots`, the first vertex for which it was set.
  std::array<std::uint32_t, kSlots> since{};
  bool open = false;          ///< true if there was a Begin without End
  bool onlyValues = false;    ///< no primitive: attributes set outside of primitives
  bool fromArrays = false;    ///< draws of arrays, which do not change current values
  bool uniform = true;        ///< true if all slots are set from the first vertex on
  bool endsOtherwise = false; ///< true if a value was set after the last vertex
  /// Several primitives whose vertices depend on each other (strips, fans, loops, polygons): the
  /// first vertices of all but the first primitive, and the indices that join them (joined.h).
  std::vector<std::uint32_t> starts, indices;
  SlotMask touched = 0;    ///< slots that were set, one bit for each
  GivenComponents given{}; ///< component counts of these slots and of the position
  CurrentValues values{};  ///< values of these slots after the primitives

  /// Returns the host's list that draws the same. At the first call `make` compiles it and returns
  /// its name.
  template <typename Make> [[nodiscard]] GLuint hostList(Make &&make) const {
    const std::lock_guard lock(m_mutex);
    if (m_hostList == 0)
      m_hostList = make();
    return m_hostList;
  }
  /// Returns that list's name, or 0 if it was not made.
  [[nodiscard]] GLuint madeHostList() const;
  /// Replays what is between Begin and End. It calls `set(slot, const float value[4], components)`
  /// for each attribute that was set, and then for kPosition, which makes a vertex. `components` is
  /// the number that the application gave.
  /// \param next called between two primitives
  template <typename Set, typename Next> void read(Set &&set, Next &&next) const {
    std::size_t begun = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (begun < starts.size() && starts[begun] == i) {
        next();
        ++begun;
      }
      const float *const vertex = data.data() + std::size_t(i) * stride;
      for (unsigned slot = 1; slot < slotCount; ++slot)
        if (i >= since[slot])
          set(int(slots[slot]), vertex + 4 * slot, mostGiven(given, slots[slot]));
      set(int(kPosition), vertex, mostGiven(given, kPosition));
    }
    for (SlotMask left = touched; left != 0; left &= left - 1) {
      const int slot = std::countr_zero(left);
      set(slot, values[std::size_t(slot)].data(), mostGiven(given, slot));
    }
  }
  /// Returns the vertices, valid while this object lives. If not `uniform`, attributes that were
  /// not set yet are undefined.
  [[nodiscard]] VertexSource source() const;
  /// Returns the vertices, with current values for attributes that were not set yet. They are valid
  /// while `store` is unchanged. Requires that `current` has the values of unsetSlots().
  [[nodiscard]] VertexSource source(const CurrentValues &current, std::vector<float> &store) const;
  /// Returns the slots that were not set before the first vertex, one bit for each.
  [[nodiscard]] std::uint32_t unsetSlots() const;

private:
  mutable std::mutex m_mutex; ///< contexts of a share group may call the list at the same time
  mutable GLuint m_hostList = 0;
};

/// Makes a Geometry of the recorder's primitive. \param fromArrays Geometry::fromArrays
[[nodiscard]] std::unique_ptr<Geometry> geometryOf(const ImmediateRecorder &recorder,
                                                   bool fromArrays = false);
/// Adds the recorder's primitive to `to` if the two can be drawn as one. Returns false if not.
[[nodiscard]] bool append(Geometry &to, const ImmediateRecorder &recorder, bool fromArrays = false);

} // namespace arbiter::state
