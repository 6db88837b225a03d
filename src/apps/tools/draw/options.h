#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/draw/drawing.h"

namespace arbiter::tools {

/// Applies the options in place of the settings in the first pass's panel.
/// \returns an empty string, or the wrong option and what was expected of it.
[[nodiscard]] std::string applyOptions(const DrawArguments &arguments, Drawing &drawing);

/// Applies values of --texture in place of the textures of the first pass's panel.
/// \returns as applyOptions().
[[nodiscard]] std::string applyTextures(const std::vector<std::string> &textures, Drawing &drawing);

/// Returns the words of --texture for images: those of `#@ texture` that make a 2D image without
/// arguments.
[[nodiscard]] std::vector<std::string_view> generatorWords();

} // namespace arbiter::tools
