#pragma once
#include <epoxy/gl.h>

#include "fp_compiler/front/nvparse/text.h"

/// nvparse's texts as calls of NV_register_combiners and NV_texture_shader.
namespace arbiter::tools {

/// Limits of the current context, as fp::nvparse::parse() wants them.
[[nodiscard]] fp::Limits stateTextLimits();

/// Makes the state the context's, with the text's values, and enables it.
void issueStateText(const fp::nvparse::Text &text);
/// Disables both.
void disableStateTexts();

/// A constant colour, matrix, scale or eye vector, by its env parameter.
void giveStateValue(int parameter, const fp::ir::Vec4 &value);

} // namespace arbiter::tools
