#pragma once
#include "state/host_draw/linked_program.h"

/// Fragment programs as the host's own ARB programs, where the rasterizer draws: of a program that
/// is new, the host mostly has no more draws than those of that frame, and its GLSL compiler would
/// take longer than all of them. A program that the host still draws with in a later frame is GLSL
/// from then on, as the specifications' text is, which hosts' own paths do not follow everywhere.
namespace arbiter::state {

/// What the fragment program of a pair is on the host. Assembly: of plain programs, of up to 256
/// instructions and without options, in the frame in which they are first drawn with, where no
/// texture compares or has the mode ALPHA and no client looks on.
[[nodiscard]] LinkedProgramCache::Fragments fragmentsOf(Context &context, const ProgramPair &pair);
/// Before a draw of the host's: the effective fragment program is assembly and must be no more. Its
/// frame is over, what it needed no longer holds, or colours are flat, of which Mesa's own path
/// takes no notice. The next choice makes it GLSL.
[[nodiscard]] bool assemblyIsOver(Context &context);

} // namespace arbiter::state
