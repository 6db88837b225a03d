#pragma once

namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

class Geometry;

/// Executes a list's primitives: the rasterizer or the host draws them, or an open one begins.
void callGeometry(Context &context, const Geometry &geometry);

} // namespace arbiter::state::software
