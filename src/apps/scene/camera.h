#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "apps/scene/panel/panel.h"

namespace arbiter::scene {

/// The GL matrices of one pass.
struct View {
  glm::mat4 modelView{1.0f};
  glm::mat4 projection{1.0f};
  glm::vec3 eye{0.0f, 0.0f, 1.0f}; ///< object coordinates
};

/// Returns the view of a camera for a picture of that size in pixels. Without a camera, and for
/// "none", object coordinates are clip coordinates, except that z points to the viewer as in
/// glOrtho.
[[nodiscard]] View viewOf(const std::optional<CameraSpec> &camera, int width, int height);

/// Returns the matrix from object coordinates to texture coordinates (times q) of the view's
/// picture, [0,1] in all three.
[[nodiscard]] glm::mat4 toTexture(const View &view);

} // namespace arbiter::scene
