#pragma once

namespace arbiter::state {

struct RasterContext;

/// Notes a command that binds or defines textures or sets how they are sampled
/// (noteTextureChange()), and that may be in a list. Cuts the list if draws of texture shaders or
/// register combiners may use it, so that they get the program for the new textures.
void noteTextureCommand(RasterContext &context);

} // namespace arbiter::state
