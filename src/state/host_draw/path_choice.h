#pragma once
#include <cstdint>

#include "state/host_draw/draw_context.h"

namespace arbiter::state {

/// When the host is given the effective programs. If the rasterizer draws, this may wait for the
/// host's next draw, which may never come. A host takes milliseconds to compile a program, and
/// making it current costs as much as some draws.
enum class HostPart : std::uint8_t { Now, WhenItDraws };

/// Chooses the effective programs and how they draw. In each stage, the application's own GLSL
/// takes precedence over ARB programs (ARB_shader_objects). Next come ATI's fragment shaders, then
/// texture shaders and register combiners (NV_fragment_program: "the fragment program replaces
/// ..."), then fixed function. It links what is needed and notes the result in `context`. Only the
/// host's ARB programs are made current, if they draw alone. Raises no error.
///
/// With WhenItDraws, and if the rasterizer may draw, it only chooses the programs
/// (DrawChoice::hostPartWaits). The next choice with Now finds out whether the host takes them as
/// GLSL, as assembly, or not at all.
[[nodiscard]] Path choosePath(DrawContext &context, HostPart part);

/// True if the application's own GLSL, a program or a pipeline, shades a stage of draws now, unless
/// a program of the layer's is bound on the host.
[[nodiscard]] bool applicationShades(DrawContext &context);

} // namespace arbiter::state
