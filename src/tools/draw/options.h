#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tools/draw/drawing.h"

namespace arbiter::tools {

/// Puts what the options say in the place of what the panel of the first pass says.
/// \returns an empty string, or what is wrong: the option and what was expected of it.
[[nodiscard]] std::string applyOptions(const DrawArguments &arguments, Drawing &drawing);

/// The words that --texture takes for an image: those of `#@ texture` that are a 2D image by
/// themselves.
[[nodiscard]] std::vector<std::string_view> generatorWords();

} // namespace arbiter::tools
