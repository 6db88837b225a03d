#pragma once

namespace arbiter::state {

class Context;

/// Which program targets a context has from its first make-current on, with the limits of the
/// active profile and of the host, and what else the profile's card had: NVIDIA's program API,
/// register combiners, texture shaders, extensions of the era. The context's capabilities and its
/// `offered` are known.
void offerTargets(Context &context);

} // namespace arbiter::state
