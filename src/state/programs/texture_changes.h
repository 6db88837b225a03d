#pragma once

/// Notes changes of bound textures, because texture shaders and register combiners depend on them.
/// Their programs depend on whether a texture is consistent, whether it has depths, and which of
/// its components the host lacks. The next draw looks once (host_draw/variants).
namespace arbiter::state {

struct ProgramContext;

/// Notes a command that binds or defines textures, or changes sampling. The next draw that depends
/// on textures queries the host. It only takes a few tests if none does.
void noteTextureChange(ProgramContext &context);

/// True if textures may have changed since a draw last looked; always if other contexts may change
/// them.
[[nodiscard]] bool texturesMayDiffer(const ProgramContext &context);

} // namespace arbiter::state
