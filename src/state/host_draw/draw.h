#pragma once
#include "state/host_draw/draw_context.h"

namespace arbiter::state {

/// Decides which path draws take, and binds what it needs. Raises no error. Returns false if draws
/// are errors now.
bool validate(DrawContext &context);
/// Does what validate() would do if nothing but env and local parameters has changed since the last
/// draw. Returns false, and does nothing, in all other cases.
[[nodiscard]] bool sendParametersAlone(DrawContext &context);
/// Does the part of validate() that a draw of the rasterizer needs: it finds the effective
/// programs. Uniforms and sampler bindings, which only the host needs, are left to the next
/// validate().
bool validatePrograms(DrawContext &context);

/// Restores the application's current program and sampler bindings on the host.
void releaseHostState(DrawContext &context);
/// Makes the host itself refuse draws, in lists too, while the effective program is not valid, as
/// the specification demands. releaseHostState() ends it.
void refuseDraws(DrawContext &context);
/// Does validate() before the host compiles and executes a segment of a list. The program must be
/// bound when the segment is executed, or its draws must be refused.
void validateForList(DrawContext &context);
/// Updates what a host list that has run may have changed.
void afterHostList(DrawContext &context);

} // namespace arbiter::state
