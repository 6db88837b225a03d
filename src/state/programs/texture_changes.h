#pragma once

/// Draws of texture shaders and of register combiners depend on which textures are bound and on
/// what they are: that a texture is consistent, that it has depths, and which of its components the
/// host does not have, choose among programs. What may have changed that is noted here, and looked
/// at once, by the next draw (programs/variants).
namespace arbiter::state {

class Context;

/// After a command that binds or defines textures, or sets how they are sampled: the next draw that
/// depends on them asks the host. A few tests where none does.
void noteTextureChange(Context &context);

/// Since a draw last asked; always where other contexts may change them.
[[nodiscard]] bool texturesMayDiffer(const Context &context);

} // namespace arbiter::state
