#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attribute_aliases.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/vertices/array_source.h"
#include "state/raster_draw/vertices/draw_command.h"

/// Vertex arrays in a display list that keeps its primitives: their vertices, as they lie in memory
/// when the list is compiled. Pointers and what enables arrays are no part of a list (OpenGL 2.1,
/// 5.4), and a draw is Begin, an ArrayElement for each vertex, and End (2.8).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

class ImmediateRecorder;

/// What reads them; the list compiler's.
class ListArrays {
public:
  /// Both outlive it. The host's own table, never the one that stands in for it.
  ListArrays(const host::HostTable &host, const HostCaps &caps)
      : m_mirror(host, caps, &m_aliases) {}
  ListArrays(const ListArrays &) = delete;
  ListArrays &operator=(const ListArrays &) = delete;

  /// The arrays that are enabled, until close(), which is called in any case.
  /// \param changed which of them, or where they are, since the last call
  /// \return false: some are of a kind that only the host reads, or not where they should be
  [[nodiscard]] bool open(Context &context, const DrawCommand &command, bool changed);
  void close(Context &context) { m_source.close(context); }
  /// Of what is open: adds the command's vertices.
  void addTo(ImmediateRecorder &recorder, const DrawCommand &command) const;
  /// The same, given to the host between Begin and End.
  void sendTo(const host::HostTable &host, const DrawCommand &command) const;

private:
  /// Calls `set(slot, value, components)` of each array, the position last, vertex by vertex.
  template <typename Set> void read(const DrawCommand &command, Set &&set) const;
  [[nodiscard]] bool isWithin(const DrawCommand &command) const;

  AttributeAliases m_aliases; ///< of the draw
  Mirror m_mirror;            ///< of which the arrays alone
  ArraySource m_source;
  bool m_symmetric = false; ///< as VertexSource::symmetric
};

/// A draw while a list is compiled: true if its vertices are a primitive of the list's now. The
/// command is legal and draws something.
[[nodiscard]] bool recordArrays(Context &context, const DrawCommand &command);
/// ArrayElement between Begin and End of a primitive that is recorded.
[[nodiscard]] bool recordElement(Context &context, GLint index);

// --- Draws of the host's, validated, whose arrays it would take for others (strangeArrays()):
// --- true, and they are drawn as what they are, Begin, an ArrayElement for each vertex, and End
// ---

[[nodiscard]] bool aliasedDraw(Context &context, const DrawCommand &command);
[[nodiscard]] bool aliasedDrawRange(Context &context, GLuint start, GLuint end,
                                    const DrawCommand &command);
/// Draws each of several draws by `takes`, or else on the host.
void drawEach(Context &context, const MultiDraw &draws,
              bool (*takes)(Context &, const DrawCommand &));
[[nodiscard]] bool aliasedMultiDrawArrays(Context &context, GLenum mode, const GLint *first,
                                          const GLsizei *count, GLsizei drawCount);
[[nodiscard]] bool aliasedMultiDrawElements(Context &context, GLenum mode, const GLsizei *count,
                                            GLenum type, const void *const *indices,
                                            GLsizei drawCount, const GLint *baseVertices);

} // namespace arbiter::state::software
