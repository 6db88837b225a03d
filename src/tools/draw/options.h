#pragma once
#include <string>

#include "tools/draw/drawing.h"

namespace arbiter::tools {

/// Puts what the options say in the place of what the panel of the first pass says.
/// \returns an empty string, or what is wrong: the option and what was expected of it.
[[nodiscard]] std::string applyOptions(const DrawArguments &arguments, Drawing &drawing);

} // namespace arbiter::tools
