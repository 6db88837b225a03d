#pragma once
#include <string>

#include "tools/capture_index.h"

/// What a captured program was drawn with, as HTML for any page.
namespace arbiter::tools {

/// The values of env, local and state parameters at its last use.
[[nodiscard]] std::string parameterTable(const CapturedProgram &program);
/// The textures of the units that it samples.
[[nodiscard]] std::string textureTable(const CapturedProgram &program);

} // namespace arbiter::tools
