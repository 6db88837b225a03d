#pragma once
#include "state/context/context.h"

/// Which extensions the layer offers in a context. Where it does not offer one, the generated entry
/// points of the extension's commands call the host ([own.offered] of dispatch/entry_points.toml).
namespace arbiter::state::offered {

[[nodiscard]] inline bool imaging(const Context &context) { return context.imaging != nullptr; }
[[nodiscard]] inline bool combiners(const Context &context) { return context.combiners != nullptr; }
[[nodiscard]] bool stageConstants(const Context &context); ///< NV_register_combiners2
[[nodiscard]] inline bool fragmentShaders(const Context &context) {
  return context.row(Target::AtiApi).offered;
}
[[nodiscard]] inline bool vertexShaders(const Context &context) {
  return context.vertexShaders != nullptr;
}
[[nodiscard]] bool nvFences(const Context &context);
[[nodiscard]] bool appleFences(const Context &context);
[[nodiscard]] bool bumpMaps(const Context &context); ///< ATI_envmap_bumpmap

} // namespace arbiter::state::offered
