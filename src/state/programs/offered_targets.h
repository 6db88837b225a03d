#pragma once

namespace arbiter::state {

struct ProgramContext;

/// Offers a context's program targets at its first make-current, with the limits of the active
/// profile and of the host. It also offers what else the profile's card had: NVIDIA's program API,
/// register combiners, texture shaders, and extensions of the time. Requires that the context's
/// capabilities and `offered` are known.
void offerTargets(ProgramContext &context);

} // namespace arbiter::state
