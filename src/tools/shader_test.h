#pragma once
#include <string>

#include "tools/capture_index.h"

namespace arbiter::tools {

/// A test for piglit's shader_runner that loads the program, sets the parameters and makes textures
/// of the kinds and sizes of its last use, and draws it on a rectangle that fills the window, where
/// every texture coordinate set runs from 0 to 1 and the primary colour is (s, t, 0, 1). It passes
/// where the program loads and draws; a probe is for its reader to add. What it cannot say
/// (matrices and other state rows, cube maps) is in comments. \returns nothing where shader_runner
/// has no such target or cannot hold the text (a NUL byte); `reason` says why.
[[nodiscard]] std::string shaderTest(const CapturedProgram &program, std::string &reason);

} // namespace arbiter::tools
