#pragma once

namespace arbiter::state {

class Context;

/// True if attributes may alias in this process: the active profile has it so, or
/// ARBITER_ATTRIBUTES.
[[nodiscard]] bool attributesMayAlias();
/// Sets `aliases` and `attributesAlias` of a context whose targets are being offered: it is
/// current, and no list is compiled.
void offerAliases(Context &context);

} // namespace arbiter::state
