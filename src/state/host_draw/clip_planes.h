#pragma once
#include <GL/gl.h>

#include <cstdint>

/// Tells whether user clip planes are enabled while a vertex program is GLSL on the host. It is
/// then drawn with a special variant (state/programs/variants/clipped_variant.h).
namespace arbiter::state {

struct DrawContext;
struct CompiledProgram;

/// True if planes would clip the program wrongly as the host's own assembly. This is so for a
/// program of NVIDIA's that computes its own position, which planes must not clip. It is also so
/// for a shader of EXT_vertex_shader if the host does not clip its programs.
[[nodiscard]] bool assemblyClipsOtherwise(const DrawContext &context,
                                          const CompiledProgram &vertex);
/// True if a vertex program must be drawn with its clipped variant now. Queries the host once after
/// a change, and only in a context that has used planes.
[[nodiscard]] bool clipPlanesMatter(DrawContext &context);
/// Returns a bit for each enabled plane, for programs that write distances. Queries the host after
/// a change.
[[nodiscard]] std::uint8_t enabledClipPlanes(DrawContext &context);
/// Notes that planes may have been enabled or disabled, by an attribute stack or another context.
/// It only takes a test if no plane was ever enabled.
void noteClipPlanesChange(DrawContext &context);
/// Notes an Enable or Disable of a plane. An Enable in a display list counts for good and for the
/// whole share group, because draws in that list are not inspected.
void noteClipPlane(DrawContext &context, bool enabled);
/// Notes that CopyContext has copied the enables of `from`.
void copyClipPlanes(const DrawContext &from, DrawContext &to);
/// Notes that a host list will be called. It may enable planes if it was compiled after the program
/// became effective.
void noteClipPlanesOfLists(DrawContext &context);
/// Notes that a host list has run, which may have enabled or disabled planes.
void noteClipPlanesAfterList(DrawContext &context);

} // namespace arbiter::state
