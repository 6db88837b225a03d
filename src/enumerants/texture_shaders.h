#pragma once
#include <optional>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/texture_shader/state.h"

/// Translates between the enumerants of NV_texture_shader, 2 and 3 and the compiler's types.
namespace arbiter::enumerants {

/// Returns the operation that SHADER_OPERATION_NV sets. \param extensions how many of the three
/// extensions count
[[nodiscard]] std::optional<fp::texture_shader::Operation> shaderOperation(GLenum name,
                                                                           int extensions);
[[nodiscard]] GLenum nameOf(fp::texture_shader::Operation operation);

/// Returns the mapping that RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV sets.
[[nodiscard]] std::optional<fp::texture_shader::Mapping> dotProductMapping(GLenum name,
                                                                           int extensions);
[[nodiscard]] GLenum nameOf(fp::texture_shader::Mapping mapping);

} // namespace arbiter::enumerants
