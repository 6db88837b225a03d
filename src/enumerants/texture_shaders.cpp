#include "enumerants/texture_shaders.h"

#include <algorithm>
#include <iterator>

namespace arbiter::enumerants {

using fp::texture_shader::Mapping;
using fp::texture_shader::Operation;

namespace {

/// The enumerants in the order of Operation.
constexpr GLenum kOperations[] = {
    GL_NONE,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_RECTANGLE_NV,
    GL_TEXTURE_CUBE_MAP,
    GL_PASS_THROUGH_NV,
    GL_CULL_FRAGMENT_NV,
    GL_OFFSET_TEXTURE_2D_NV,
    GL_OFFSET_TEXTURE_2D_SCALE_NV,
    GL_OFFSET_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_TEXTURE_RECTANGLE_SCALE_NV,
    GL_DEPENDENT_AR_TEXTURE_2D_NV,
    GL_DEPENDENT_GB_TEXTURE_2D_NV,
    GL_DOT_PRODUCT_NV,
    GL_DOT_PRODUCT_TEXTURE_2D_NV,
    GL_DOT_PRODUCT_TEXTURE_RECTANGLE_NV,
    GL_DOT_PRODUCT_TEXTURE_CUBE_MAP_NV,
    GL_DOT_PRODUCT_REFLECT_CUBE_MAP_NV,
    GL_DOT_PRODUCT_CONST_EYE_REFLECT_CUBE_MAP_NV,
    GL_DOT_PRODUCT_DIFFUSE_CUBE_MAP_NV,
    GL_DOT_PRODUCT_DEPTH_REPLACE_NV,
    GL_TEXTURE_3D,
    GL_DOT_PRODUCT_TEXTURE_3D_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_2D_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_2D_SCALE_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_PROJECTIVE_TEXTURE_RECTANGLE_SCALE_NV,
    GL_OFFSET_HILO_TEXTURE_2D_NV,
    GL_OFFSET_HILO_TEXTURE_RECTANGLE_NV,
    GL_OFFSET_HILO_PROJECTIVE_TEXTURE_2D_NV,
    GL_OFFSET_HILO_PROJECTIVE_TEXTURE_RECTANGLE_NV,
    GL_DEPENDENT_HILO_TEXTURE_2D_NV,
    GL_DEPENDENT_RGB_TEXTURE_3D_NV,
    GL_DEPENDENT_RGB_TEXTURE_CUBE_MAP_NV,
    GL_DOT_PRODUCT_PASS_THROUGH_NV,
    GL_DOT_PRODUCT_TEXTURE_1D_NV,
    GL_DOT_PRODUCT_AFFINE_DEPTH_REPLACE_NV,
};
static_assert(std::size(kOperations) == fp::texture_shader::kOperations);

constexpr GLenum kMappings[] = {GL_UNSIGNED_IDENTITY_NV, GL_EXPAND_NORMAL_NV,
                                GL_FORCE_BLUE_TO_ONE_NV};

/// Returns which of the three extensions introduced the operation.
int extensionOf(Operation operation) {
  return operation < Operation::Texture3D ? 1 : operation < Operation::OffsetProjective2D ? 2 : 3;
}

} // namespace

std::optional<Operation> shaderOperation(GLenum name, int extensions) {
  const auto *const at = std::find(std::begin(kOperations), std::end(kOperations), name);
  if (at == std::end(kOperations))
    return std::nullopt;
  const auto operation = Operation(at - std::begin(kOperations));
  return extensionOf(operation) <= extensions ? std::optional(operation) : std::nullopt;
}

GLenum nameOf(Operation operation) { return kOperations[std::size_t(operation)]; }

std::optional<Mapping> dotProductMapping(GLenum name, int extensions) {
  const auto *const at = std::find(std::begin(kMappings), std::end(kMappings), name);
  if (at == std::end(kMappings) || (name == GL_FORCE_BLUE_TO_ONE_NV && extensions < 3))
    return std::nullopt;
  return Mapping(at - std::begin(kMappings));
}

GLenum nameOf(Mapping mapping) { return kMappings[std::size_t(mapping)]; }

} // namespace arbiter::enumerants
