#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attribute_aliases.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/vertices/array_source.h"
#include "state/raster_draw/vertices/draw_command.h"

/// Records draws of vertex arrays in a display list that keeps its primitives. It reads the
/// vertices when the list is compiled, because pointers and enables are no part of a list (OpenGL
/// 2.1, 5.4). A draw equals Begin, an ArrayElement for each vertex, and End (2.8).
namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

class ImmediateRecorder;

/// Reads the arrays for the list compiler.
class ListArrays {
public:
  /// Both arguments must outlive the object. `host` is the real table, never a recorder's.
  ListArrays(const host::HostTable &host, const HostCaps &caps)
      : m_mirror(host, caps, &m_aliases) {}
  ListArrays(const ListArrays &) = delete;
  ListArrays &operator=(const ListArrays &) = delete;

  /// Opens the enabled arrays until close(), which must always be called.
  /// \param changed true if the arrays may have changed since the last call
  /// \return false if some can only be read by the host, or lie outside their buffers
  [[nodiscard]] bool open(RasterContext &context, const DrawCommand &command, bool changed);
  void close(RasterContext &context) { m_source.close(context); }
  /// Adds the command's vertices. Requires open().
  void addTo(ImmediateRecorder &recorder, const DrawCommand &command) const;
  /// Sends the command's vertices to the host, between Begin and End. Requires open().
  void sendTo(const host::HostTable &host, const DrawCommand &command) const;

private:
  /// Calls `set(slot, value, components)` for each array, vertex by vertex, the position last.
  template <typename Set> void read(const DrawCommand &command, Set &&set) const;
  [[nodiscard]] bool isWithin(const DrawCommand &command) const;

  AttributeAliases m_aliases; ///< the aliases during the draw
  Mirror m_mirror;            ///< only its arrays are used
  ArraySource m_source;
  bool m_symmetric = false; ///< see VertexSource::symmetric
};

/// Records a draw in the list being compiled. Returns false if the host must. Requires that the
/// command is legal and draws something.
[[nodiscard]] bool recordArrays(RasterContext &context, const DrawCommand &command);
/// Records ArrayElement in an open primitive. Returns false if none is being recorded.
[[nodiscard]] bool recordElement(RasterContext &context, GLint index);

// --- Draws by the host whose arrays it would misread (strangeArrays()). They are sent as Begin, an
// ArrayElement for each vertex, and End, and return true. Requires that state is validated. ---

[[nodiscard]] bool aliasedDraw(RasterContext &context, const DrawCommand &command);
[[nodiscard]] bool aliasedDrawRange(RasterContext &context, GLuint start, GLuint end,
                                    const DrawCommand &command);
/// Executes a multi-draw: each draw by `takes`, or else on the host.
void drawEach(RasterContext &context, const MultiDraw &draws,
              bool (*takes)(RasterContext &, const DrawCommand &));
[[nodiscard]] bool aliasedMultiDrawArrays(RasterContext &context, GLenum mode, const GLint *first,
                                          const GLsizei *count, GLsizei drawCount);
[[nodiscard]] bool aliasedMultiDrawElements(RasterContext &context, GLenum mode,
                                            const GLsizei *count, GLenum type,
                                            const void *const *indices, GLsizei drawCount,
                                            const GLint *baseVertices);

} // namespace arbiter::state
