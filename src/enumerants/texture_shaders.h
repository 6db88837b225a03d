#pragma once
#include <optional>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/texture_shader/state.h"

/// The enumerants of NV_texture_shader, 2 and 3 and the numbers that the compiler has for them.
namespace arbiter::enumerants {

/// A SHADER_OPERATION_NV of the first `extensions` of the three.
[[nodiscard]] std::optional<fp::texture_shader::Operation> shaderOperation(GLenum name,
                                                                           int extensions);
[[nodiscard]] GLenum nameOf(fp::texture_shader::Operation operation);

/// A RGBA_UNSIGNED_DOT_PRODUCT_MAPPING_NV.
[[nodiscard]] std::optional<fp::texture_shader::Mapping> dotProductMapping(GLenum name,
                                                                           int extensions);
[[nodiscard]] GLenum nameOf(fp::texture_shader::Mapping mapping);

} // namespace arbiter::enumerants
