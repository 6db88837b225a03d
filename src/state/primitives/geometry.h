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

/// Primitives of a display list (OpenGL 1.4, 5.4) as the application gave them: vertices that stay
/// where they are from call to call.
namespace arbiter::state::software {

/// Vertices of a primitive where primitives of the mode may follow each other in one; 0: they may
/// not, as they share vertices.
[[nodiscard]] std::uint32_t independentVertices(GLenum mode);

/// One or more primitives of one mode, or the beginning of one: a list may leave it open, or go on
/// in it with a command that is no vertex (CallList). An attribute that was not set in the list
/// when its vertex was made has the value that is current when the list is called.
class Geometry {
public:
  GLenum mode = GL_POINTS;
  std::uint32_t count = 0;  ///< vertices
  std::vector<float> data;  ///< `count` times `stride` floats
  std::uint32_t stride = 4; ///< floats: a vec4 for each of `slots`, the position first
  std::uint32_t slotCount = 1;
  std::array<std::uint8_t, kSlots> slots{};
  /// From which vertex on each of them is set.
  std::array<std::uint32_t, kSlots> since{};
  bool open = false;          ///< Begin without End
  bool onlyValues = false;    ///< no primitive: attributes that were set outside of them
  bool fromArrays = false;    ///< draws of arrays: current values stay what they are
  bool uniform = true;        ///< all of them from the first vertex on
  bool endsOtherwise = false; ///< a value was set behind the last vertex
  /// Where several primitives depend on their own vertices only (strips, fans, loops, polygons):
  /// the first vertices of all but the first, and the indices that join them (joined.h).
  std::vector<std::uint32_t> starts, indices;
  SlotMask touched = 0;    ///< slots that were set, one bit each
  GivenComponents given{}; ///< of these and of the position
  CurrentValues values{};  ///< of these, as the primitives leave them behind

  /// The host's list that draws the same, which `make` makes when it is first asked for and gives
  /// the name of.
  template <typename Make> [[nodiscard]] GLuint hostList(Make &&make) const {
    const std::lock_guard lock(m_mutex);
    if (m_hostList == 0)
      m_hostList = make();
    return m_hostList;
  }
  /// That list, or 0.
  [[nodiscard]] GLuint madeHostList() const;
  /// What is between Begin and End: calls `set(slot, const float value[4], components)` of each
  /// attribute as it is set, and of kPosition for a vertex, with as many components as were given.
  /// \param next called between one primitive and the next
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
  /// The vertices, for as long as this lives. Where not `uniform`, attributes that were not set yet
  /// are undefined in it.
  [[nodiscard]] VertexSource source() const;
  /// The vertices with what is current for what was not set yet, for as long as `store` is not
  /// changed. Requires: `current` is known of unsetSlots().
  [[nodiscard]] VertexSource source(const CurrentValues &current, std::vector<float> &store) const;
  /// The slots that were not set when the first vertex was made, one bit each.
  [[nodiscard]] std::uint32_t unsetSlots() const;

private:
  mutable std::mutex m_mutex; ///< contexts of a share group may call the list at the same time
  mutable GLuint m_hostList = 0;
};

/// What the recorder has of a primitive. \param fromArrays Geometry::fromArrays
[[nodiscard]] std::unique_ptr<Geometry> geometryOf(const ImmediateRecorder &recorder,
                                                   bool fromArrays = false);
/// Adds the recorder's primitive to `to`, if the two are drawn alike as one.
[[nodiscard]] bool append(Geometry &to, const ImmediateRecorder &recorder, bool fromArrays = false);

} // namespace arbiter::state::software
