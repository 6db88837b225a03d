#pragma once
#include <string>

#include "apps/tools/capture_index.h"

/// Formats the parameters and textures of a captured program as HTML.
namespace arbiter::tools {

/// Returns the values of env, local and state parameters at the program's last use.
[[nodiscard]] std::string parameterTable(const CapturedProgram &program);
/// Returns the textures of the units from which the program samples.
[[nodiscard]] std::string textureTable(const CapturedProgram &program);

} // namespace arbiter::tools
