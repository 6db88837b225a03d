#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/panel/panel.h"

namespace arbiter::scene {

/// GL's matrices of one pass.
struct View {
  glm::mat4 modelView{1.0f};
  glm::mat4 projection{1.0f};
  glm::vec3 eye{0.0f, 0.0f, 1.0f}; ///< object coordinates
};

/// Of a camera over a picture of that many pixels. Without a camera, and for "none", object
/// coordinates are clip coordinates, but for z, which points to the viewer as in glOrtho.
[[nodiscard]] View viewOf(const std::optional<CameraSpec> &camera, int width, int height);

/// From object coordinates to texture coordinates (times q) of what the view draws: [0,1] in all
/// three.
[[nodiscard]] glm::mat4 toTexture(const View &view);

} // namespace arbiter::scene
