#pragma once
#include <GL/gl.h>

#include <cstdint>

/// Whether user clip planes are enabled beside a vertex program that is GLSL on the host, which is
/// drawn in a form of its own then (state/programs/variants/clipped_variant.h).
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// Whether planes do not clip the program as they are to while it is the host's own assembly: one
/// of NVIDIA's that gives a position of its own, which they are not to clip; and a shader of
/// EXT_vertex_shader where the host's programs escape them.
[[nodiscard]] bool assemblyClipsOtherwise(const Context &context, const CompiledProgram &vertex);
/// Whether a vertex program has to be drawn in its clipped form now. Asks the host after a change,
/// once, and only in a context that has used planes.
[[nodiscard]] bool clipPlanesMatter(Context &context);
/// A bit for each plane that is enabled, for programs that write distances of their own. Asks the
/// host after a change.
[[nodiscard]] std::uint8_t enabledClipPlanes(Context &context);
/// Planes may have been enabled or disabled, by an attribute stack or by another context. One test
/// where none was ever enabled.
void noteClipPlanesChange(Context &context);
/// Enable or Disable of a plane. An enable that goes into a display list counts for good, and for
/// all of the share group: draws of that list follow it without being looked at.
void noteClipPlane(Context &context, bool enabled);
/// CopyContext brought the enables of `from`.
void copyClipPlanes(const Context &from, Context &to);
/// Before a host list is called: one that was compiled since the program became effective may
/// enable planes.
void noteClipPlanesOfLists(Context &context);
/// After a host list: it may have enabled or disabled planes.
void noteClipPlanesAfterList(Context &context);

} // namespace arbiter::state
