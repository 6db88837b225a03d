#pragma once

namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

class Geometry;

/// The list is called: its primitives are drawn, by us or by the host, or one begins.
void callGeometry(Context &context, const Geometry &geometry);

} // namespace arbiter::state::software
