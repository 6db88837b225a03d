#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/mirror/attributes.h"

/// The way of a draw that may be ours: does it qualify, what function shades it, which images it
/// goes to; else the host draws, after it was brought up to date.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

struct PlacedBits;

/// `count` vertices from `first`, or by `indices` (of type GL_UNSIGNED_BYTE, _SHORT, _INT; an
/// offset into the element buffer where one is bound) with `baseVertex` added.
struct DrawCommand {
  GLenum mode = GL_TRIANGLES;
  GLint first = 0;
  GLsizei count = 0;
  GLenum indexType = 0; ///< 0: no indices
  const void *indices = nullptr;
  GLint baseVertex = 0;
};

/// For all of them programs are valid (validatePrograms). Where the host draws after all, it has
/// been validated for and brought up to date.
/// True: drawn. False: the host's; hostDraws() has been called, and the caller goes on.
[[nodiscard]] bool drawArrays(Context &context, const DrawCommand &command);
/// The same of the first `count` vertices of `source`; null: they are none that we draw.
[[nodiscard]] bool drawVertices(Context &context, GLenum mode, const VertexSource *source,
                                std::uint32_t count);
/// The same of fragments that no vertices give (bitmap.h).
[[nodiscard]] bool drawBits(Context &context, const PlacedBits &bits);
/// At Begin: true if the primitive is kept back from the host; then end() draws it, or has the host
/// draw it after all. False: hostDraws() has been called.
[[nodiscard]] bool begin(Context &context, GLenum mode);
void end(Context &context);

} // namespace arbiter::state::software
