#pragma once
#include <cstdint>

#include "state/core/context.h"

namespace arbiter::state {

/// When the host is given what is effective. Where the rasterizer draws, that may wait for the
/// host's next draw, which may never come: a host compiles a program in milliseconds, and making it
/// current costs as much as some draws.
enum class HostPart : std::uint8_t { Now, WhenItDraws };

/// Which program is effective, and how it draws: stage by stage the application's own GLSL wins
/// over ARB programs (ARB_shader_objects), these over ATI's fragment shaders, these over texture
/// shaders and register combiners (NV_fragment_program: "the fragment program replaces ..."), and
/// these over fixed function. Links what is to be linked, and notes it in `context`; nothing is
/// made current but the host's ARB programs, where they are all that draws. Raises no error.
///
/// With WhenItDraws, and where the rasterizer may draw, the programs are chosen and no more
/// (Context::hostPartWaits). Whether the host takes them as GLSL, as assembly or not at all is then
/// told by the next choice with Now.
[[nodiscard]] Path choosePath(Context &context, HostPart part);

/// The application's own GLSL, a program or a pipeline, has a part in draws now, as far as no
/// program of the layer's is bound on the host.
[[nodiscard]] bool applicationShades(Context &context);

} // namespace arbiter::state
