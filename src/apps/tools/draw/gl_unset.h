#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/ir/interface.h"

namespace arbiter::tools {

/// Makes a texture for a unit that no line of a document names. It shows the checker with the
/// unit's number (scene/texture/unset.h), for the target that is sampled. A cube map shows it on
/// each face; a rectangle is as large as the picture. A shadow texture has depths: the number is
/// farthest, its squares are nearer.
/// \returns its name, bound to nothing; the caller owns it
[[nodiscard]] GLuint makeUnsetTexture(unsigned unit, fp::ir::TexTarget target, int pictureWidth,
                                      int pictureHeight);

} // namespace arbiter::tools
