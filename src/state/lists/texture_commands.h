#pragma once

namespace arbiter::state {

class Context;

/// After a command that may go into a list, and that binds or defines textures or sets how they are
/// sampled: noteTextureChange(). A list that draws of texture shaders or register combiners may be
/// made from is cut here, so that what follows is drawn with the program for the new textures.
void noteTextureCommand(Context &context);

} // namespace arbiter::state
