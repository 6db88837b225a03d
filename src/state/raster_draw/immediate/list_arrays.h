#pragma once
#include <cstdint>

#include <GL/gl.h>

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
  ListArrays(const host::HostTable &host, const HostCaps &caps) : m_mirror(host, caps) {}

  /// The arrays that are enabled, until close(), which is called in any case.
  /// \param changed which of them, or where they are, since the last call
  /// \return false: some are of a kind that only the host reads, or not where they should be
  [[nodiscard]] bool open(Context &context, const DrawCommand &command, bool changed);
  void close(Context &context) { m_source.close(context); }
  /// Of what is open: adds the command's vertices.
  void addTo(ImmediateRecorder &recorder, const DrawCommand &command) const;

private:
  [[nodiscard]] bool isWithin(const DrawCommand &command) const;

  Mirror m_mirror; ///< of which the arrays alone
  ArraySource m_source;
};

/// A draw while a list is compiled: true if its vertices are a primitive of the list's now. The
/// command is legal and draws something.
[[nodiscard]] bool recordArrays(Context &context, const DrawCommand &command);
/// ArrayElement between Begin and End of a primitive that is recorded.
[[nodiscard]] bool recordElement(Context &context, GLint index);

} // namespace arbiter::state::software
