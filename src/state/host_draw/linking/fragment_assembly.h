#pragma once
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"

/// Decides which fragment programs are the host's own ARB programs, because that is better than
/// GLSL. There are two cases.
///
/// Where the rasterizer draws, a new program is assembly in its first frame. Mostly the host has no
/// more draws for it than in that frame, and its GLSL compiler would take longer than all of them.
/// If the host still draws with it in a later frame, it becomes GLSL. GLSL follows the
/// specifications, which hosts' own paths do not do everywhere.
///
/// Over a host whose own fragment programs draw correctly (HostCaps::ownFragments), programs stay
/// assembly. Pictures and the driver's time are then those of the bare host; GLSL makes program
/// changes slower. An exception is a program whose parameters change before many small draws
/// (change_pace.h): the driver is faster with GLSL then.
namespace arbiter::state {

/// Returns what the fragment program of a pair becomes on the host. It is assembly if it has up to
/// 256 instructions and no options, no texture is compared or has the depth mode ALPHA, and no
/// client is attached. Programs that stay assembly may have fog and draw buffers, but must write no
/// depth.
[[nodiscard]] LinkedProgramCache::Fragments fragmentsOf(DrawContext &context,
                                                        const ProgramPair &pair);
/// True if the effective fragment program is assembly but must become GLSL before the host's next
/// draw. Its frame or its time is over, a condition no longer holds, or colours are flat, which
/// Mesa's own path ignores. The next choice makes it GLSL.
[[nodiscard]] bool assemblyIsOver(DrawContext &context);

} // namespace arbiter::state
