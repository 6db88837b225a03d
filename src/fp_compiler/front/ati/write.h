#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ati/shader.h"

namespace arbiter::fp::ati {

/// Writes the shader as a text of ATI_text_fragment_shader with the same meaning, one statement a
/// line. The text declares the constants that the shader reads: literals and parameters. Returns
/// nothing if the language cannot express the shader: with texture coordinates beyond t5, a literal
/// outside of [0,1], or a dot product whose alpha has another destination than its colour.
[[nodiscard]] std::optional<std::string> write(const Shader &shader);

} // namespace arbiter::fp::ati
