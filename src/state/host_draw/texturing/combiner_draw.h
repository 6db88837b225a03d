#pragma once
#include <memory>

#include "fp_compiler/emit.h"

/// Chooses the program for draws with register combiners. It depends on their state, the targets
/// that the units sample, whether their textures are depths and compared, and on fog.
namespace arbiter::state {

struct DrawContext;
struct CompiledProgram;

/// Returns the program of the combiners' current state. Queries the host. Requires that
/// REGISTER_COMBINERS_NV is enabled.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
chooseCombinerProgram(DrawContext &context, const fp::GlslHost &host);

/// True if a client of control has switched off the combiners' current program, and no texture
/// shaders precede them. Draws are then done as if REGISTER_COMBINERS_NV were disabled.
[[nodiscard]] bool combinersSwitchedOff(DrawContext &context);

/// True if the sampled textures may have become depths, or ceased to be: after noteTextureChange(),
/// and always if other contexts may change them.
[[nodiscard]] bool mayFollowCombinedDepths(const DrawContext &context);
/// Checks the textures before a draw if mayFollowCombinedDepths(). Has the program chosen anew if
/// one differs from the time of the choice. Queries the host.
void followCombinedDepths(DrawContext &context);

} // namespace arbiter::state
