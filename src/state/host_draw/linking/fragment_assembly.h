#pragma once
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"

/// Fragment programs as the host's own ARB programs, where that is better than GLSL:
///
/// Where the rasterizer draws. Of a program that is new, the host mostly has no more draws than
/// those of that frame, and its GLSL compiler would take longer than all of them. A program that
/// the host still draws with in a later frame is GLSL from then on, as the specifications' text is,
/// which hosts' own paths do not follow everywhere.
///
/// Over a host whose own fragment programs draw as they should (HostCaps::ownFragments), for good:
/// pictures are those of the bare host then, and so is the driver's time, which GLSL costs more of
/// where programs change. But a program whose parameters change before one small draw after the
/// other is GLSL from then on (change_pace.h), where the driver takes less for that.
namespace arbiter::state {

/// What the fragment program of a pair is on the host. Assembly: of programs of up to 256
/// instructions and without options (for good: with fog and draw buffers, and without a depth),
/// where no texture compares or has the mode ALPHA and no client looks on.
[[nodiscard]] LinkedProgramCache::Fragments fragmentsOf(Context &context, const ProgramPair &pair);
/// Before a draw of the host's: the effective fragment program is assembly and must be no more. Its
/// frame or its time is over, what it needed no longer holds, or colours are flat, of which Mesa's
/// own path takes no notice. The next choice makes it GLSL.
[[nodiscard]] bool assemblyIsOver(Context &context);

} // namespace arbiter::state
