#pragma once
#include "state/core/context.h"

namespace arbiter::state {

/// Decides which path draws take and binds what it needs, raising no error. False if draws are
/// errors now.
bool validate(Context &context);
/// What validate() comes to where nothing but env and local values may have changed since the last
/// draw: without them the draw would go straight to the host. False: it is another case, and
/// nothing is done.
[[nodiscard]] bool sendParametersAlone(Context &context);
/// The part of validate() that a draw of the rasterizer's needs: what is effective. What only the
/// host needs, uniforms and sampler bindings, is left for the validate() before its next draw.
bool validatePrograms(Context &context);

/// The host's current program becomes the application's again, and its sampler bindings too.
void releaseHostState(Context &context);
/// While the effective program is not valid: makes the host itself refuse draws, in lists too, as
/// the specification asks for. releaseHostState() ends it.
void refuseDraws(Context &context);
/// validate() before the host compiles and executes a segment of a list: what it executes must
/// find its program bound, or be refused.
void validateForList(Context &context);
/// A host list ran: what it may have changed is looked at again.
void afterHostList(Context &context);

/// The extensions that the application sees; made at the first call.
[[nodiscard]] const Identity &applicationIdentity(Context &context);

} // namespace arbiter::state
