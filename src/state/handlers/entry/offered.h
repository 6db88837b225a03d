#pragma once
#include "state/programs/program_context.h"

/// Which extensions the layer offers in a context. Where it does not offer one, the generated entry
/// points of the extension's commands call the host ([own.offered] of dispatch/entry_points.toml).
namespace arbiter::state::offered {

[[nodiscard]] inline bool imaging(const ProgramContext &context) {
  return context.imaging != nullptr;
}
[[nodiscard]] inline bool combiners(const ProgramContext &context) {
  return context.combiners != nullptr;
}
[[nodiscard]] bool stageConstants(const ProgramContext &context); ///< NV_register_combiners2
[[nodiscard]] inline bool fragmentShaders(const ProgramContext &context) {
  return context.row(Target::AtiApi).offered;
}
[[nodiscard]] inline bool vertexShaders(const ProgramContext &context) {
  return context.vertexShaders != nullptr;
}
[[nodiscard]] bool nvFences(const ProgramContext &context);
[[nodiscard]] bool appleFences(const ProgramContext &context);
[[nodiscard]] bool bumpMaps(const ProgramContext &context); ///< ATI_envmap_bumpmap
/// NV_vertex_program and the extensions that build on it.
[[nodiscard]] inline bool nvLanguages(const ProgramContext &context) {
  return context.nv != nullptr;
}

/// Raises GL_INVALID_OPERATION and returns true if the layer offers programs in the context,
/// because the profile's card does not have the command then. Returns false if the host draws all
/// programs, and has to have the command ([own.refused]).
[[nodiscard]] bool refuses(ProgramContext &context, const char *why);

} // namespace arbiter::state::offered
