#pragma once
#include "state/core/context.h"

namespace arbiter::state {

/// Decides which path draws take, and binds what it needs. Raises no error. Returns false if draws
/// are errors now.
bool validate(Context &context);
/// Does what validate() would do if nothing but env and local parameters has changed since the last
/// draw. Returns false, and does nothing, in all other cases.
[[nodiscard]] bool sendParametersAlone(Context &context);
/// Does the part of validate() that a draw of the rasterizer needs: it finds the effective
/// programs. Uniforms and sampler bindings, which only the host needs, are left to the next
/// validate().
bool validatePrograms(Context &context);

/// Restores the application's current program and sampler bindings on the host.
void releaseHostState(Context &context);
/// Makes the host itself refuse draws, in lists too, while the effective program is not valid, as
/// the specification demands. releaseHostState() ends it.
void refuseDraws(Context &context);
/// Does validate() before the host compiles and executes a segment of a list. The program must be
/// bound when the segment is executed, or its draws must be refused.
void validateForList(Context &context);
/// Updates what a host list that has run may have changed.
void afterHostList(Context &context);

/// Returns the extensions that the application sees; computed at the first call.
[[nodiscard]] const Identity &applicationIdentity(Context &context);

} // namespace arbiter::state
