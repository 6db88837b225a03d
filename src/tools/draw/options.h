#pragma once
#include <string>

#include "tools/draw/drawing.h"

namespace arbiter::tools {

/// Applies the options in place of the settings in the first pass's panel.
/// \returns an empty string, or the wrong option and what was expected of it.
[[nodiscard]] std::string applyOptions(const DrawArguments &arguments, Drawing &drawing);

} // namespace arbiter::tools
