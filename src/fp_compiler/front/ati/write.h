#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ati/shader.h"

namespace arbiter::fp::ati {

/// The shader as a text of ATI_text_fragment_shader that means the same, a statement a line. Its
/// constants are those that it reads: literals, and parameters. Nothing for one that the language
/// has no words for: a set of texture coordinates beyond t5, a literal outside of [0,1], or a dot
/// product whose alpha goes elsewhere than its colour.
[[nodiscard]] std::optional<std::string> write(const Shader &shader);

} // namespace arbiter::fp::ati
