#pragma once
#include <memory>

#include "fp_compiler/emit.h"
#include "fp_compiler/texture_shader/state.h"

/// Chooses the program for draws with texture shaders, from their settings and the state around
/// them.
namespace arbiter::state {

struct DrawContext;
struct CompiledProgram;

/// Returns the program of the context's texture shaders under the host's present state: the bound
/// textures, texture environments or register combiners, and fog. If TEXTURE_SHADER_NV is disabled,
/// it is a program for conventional texturing. Never null. Requires that the context has texture
/// shaders.
/// \param combines true if register combiners take the units' results
[[nodiscard]] std::shared_ptr<const CompiledProgram>
chooseTextureShaderProgram(DrawContext &context, const fp::GlslHost &host, bool combines);

/// True if a client of control has switched off the current program of texture shaders. Draws are
/// then done as if TEXTURE_SHADER_NV were disabled. The functions below use the last answer.
[[nodiscard]] bool texturesSwitchedOff(DrawContext &context, bool combines);

/// True if the layer must shade fixed function or register combiners although TEXTURE_SHADER_NV is
/// disabled: an enabled unit has a texture format of NV_texture_shader, or an environment of the
/// layer's. Queries the host once any of these was used.
[[nodiscard]] bool texturesNeedLayer(DrawContext &context);

/// True if the next draw must check the bound textures, on which consistency depends: after
/// noteTextureChange(), and always if other contexts may change them.
[[nodiscard]] bool mayFollowTextures(const DrawContext &context);
/// Checks the bound textures, and has the program chosen anew if they differ.
void followTextures(DrawContext &context);

/// Returns SHADER_CONSISTENT_NV of a unit.
[[nodiscard]] bool stageIsConsistent(DrawContext &context, int unit);

} // namespace arbiter::state
