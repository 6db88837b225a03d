#pragma once

namespace arbiter::state {

struct ProgramContext;

/// True if attributes may alias in this process, because of the active profile or
/// ARBITER_ATTRIBUTES.
[[nodiscard]] bool attributesMayAlias();
/// Sets `aliases` and `attributesAlias` of a context whose targets are being offered. Requires that
/// it is current and compiles no list.
void offerAliases(ProgramContext &context);

} // namespace arbiter::state
