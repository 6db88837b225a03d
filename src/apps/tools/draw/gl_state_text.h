#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/front/nvparse/text.h"

/// Translates nvparse texts into calls of NV_register_combiners and NV_texture_shader.
namespace arbiter::tools {

/// Returns the current context's limits for fp::nvparse::parse().
[[nodiscard]] fp::Limits stateTextLimits();

/// Sets the text's state and values in the current context, and enables it.
void issueStateText(const fp::nvparse::Text &text);
/// Disables register combiners and texture shaders.
void disableStateTexts();

/// Sets a constant color, matrix, scale or eye vector.
/// \param parameter its env parameter
void giveStateValue(int parameter, const fp::ir::Vec4 &value);

} // namespace arbiter::tools
