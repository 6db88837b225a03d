#pragma once
#include <string>

#include "apps/tools/capture_index.h"

namespace arbiter::tools {

/// Returns a test for piglit's shader_runner that loads the program. It sets the parameters of the
/// program's last use, and makes textures of the same kinds and sizes. It draws a rectangle over
/// the whole window, where each texture coordinate set runs from 0 to 1. The primary color is (s,
/// t, 0, 1). The test passes if the program loads and draws; its reader can add a probe. Comments
/// list what the test cannot express: matrices and other state rows, cube maps.
/// \returns nothing if shader_runner has no such target or cannot hold the text (a NUL byte);
/// `reason` says why.
[[nodiscard]] std::string shaderTest(const CapturedProgram &program, std::string &reason);

} // namespace arbiter::tools
