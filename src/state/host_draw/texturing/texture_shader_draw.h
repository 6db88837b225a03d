#pragma once
#include <memory>

#include "fp_compiler/emit.h"
#include "fp_compiler/texture_shader/state.h"

/// Texture shaders at a draw: which program the settings and the state around them make.
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The program of the context's texture shaders under the host's present state: what is bound to
/// the targets that they sample, texture environments or register combiners, fog. Where
/// TEXTURE_SHADER_NV is disabled that of conventional texturing. Never null. Requires that the
/// context has them.
/// \param combines register combiners take the units' results
[[nodiscard]] std::shared_ptr<const CompiledProgram>
texturesEffective(Context &context, const fp::GlslHost &host, bool combines);

/// A client of control has switched off what texture shaders are now: draws are as if
/// TEXTURE_SHADER_NV, which is enabled, were not. The functions below follow the last answer.
[[nodiscard]] bool texturesSwitchedOff(Context &context, bool combines);

/// Whether fixed function's fragments, or register combiners', are the layer's though
/// TEXTURE_SHADER_NV is disabled: an enabled unit has a texture of a format of NV_texture_shader,
/// or an environment of the layer's. Asks the host, once there were such.
[[nodiscard]] bool texturesNeedLayer(Context &context);

/// Whether the next draw must look which textures are bound: consistency depends on them. After
/// what may have changed them (noteTextureChange()), and always where other contexts may.
[[nodiscard]] bool mayFollowTextures(const Context &context);
/// Looks; the next choice is another one if they are others.
void followTextures(Context &context);

/// SHADER_CONSISTENT_NV of a unit.
[[nodiscard]] bool stageIsConsistent(Context &context, int unit);

} // namespace arbiter::state
