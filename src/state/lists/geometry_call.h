#pragma once

namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

class Geometry;

/// Executes a list's primitives: the rasterizer or the host draws them, or an open one begins.
void callGeometry(RasterContext &context, const Geometry &geometry);

} // namespace arbiter::state
