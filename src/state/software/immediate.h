#pragma once
#include <cstdint>
#include <vector>

#include <GL/gl.h>

#include "state/software/attributes.h"

/// Begin/End kept back from the host: the vertices of one primitive as they come. The generated
/// entry points of glVertex, glColor and their kin call set() and vertex() while
/// ContextHot::recordsVertices is set, and the host else.
namespace arbiter::state::software {

class ImmediateRecorder {
public:
  /// A primitive opens; attributes start as `current`.
  void begin(GLenum mode, const CurrentValues &current);
  /// glColor, glTexCoord .. : all four components, defaults filled in.
  void set(int slot, float x, float y, float z, float w);
  /// glVertex, or glVertexAttrib of 0.
  void vertex(float x, float y, float z, float w);
  /// The primitive is whole. The source is valid until the next begin().
  [[nodiscard]] VertexSource end();

  [[nodiscard]] GLenum mode() const { return m_mode; }
  [[nodiscard]] std::uint32_t count() const { return m_count; }
  /// Slots that were set since begin(), one bit each, and the values now: what the host must be
  /// told.
  [[nodiscard]] std::uint32_t touched() const { return m_touched; }
  [[nodiscard]] const CurrentValues &values() const { return m_values; }
  /// No memory was left: vertices are missing.
  [[nodiscard]] bool failed() const { return m_failed; }

private:
  GLenum m_mode = GL_POINTS;
  std::uint32_t m_count = 0;
  std::uint32_t m_touched = 0;
  bool m_failed = false;
  CurrentValues m_values{};
  /// Vertices, each `m_slots` vec4s: position first, then the touched slots in order of first use.
  std::vector<float> m_data;
  std::vector<std::uint8_t> m_slots;
};

} // namespace arbiter::state::software
