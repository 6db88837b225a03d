#include "apps/scene/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace arbiter::scene {

namespace {

View orbit(const CameraSpec &camera, float aspect) {
  const auto get = [&](const char *name) { return float(camera.argument(name)); };
  const float yaw = glm::radians(get("yaw")), pitch = glm::radians(get("pitch"));
  const glm::vec3 middle(get("x"), get("y"), get("z"));
  const float distance = get("distance");
  View view;
  // The view is made of rotations, not of a direction to look along, so that a view straight from
  // above needs no special case.
  view.modelView = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -distance));
  view.modelView = glm::rotate(view.modelView, pitch, glm::vec3(1, 0, 0));
  view.modelView = glm::rotate(view.modelView, -yaw, glm::vec3(0, 1, 0));
  view.modelView = glm::translate(view.modelView, -middle);
  view.projection = glm::perspective(glm::radians(get("fov")), aspect, get("near"), get("far"));
  const glm::vec3 away(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                       std::cos(yaw) * std::cos(pitch));
  view.eye = middle + distance * away;
  return view;
}

} // namespace

View viewOf(const std::optional<CameraSpec> &camera, int width, int height) {
  if (camera && camera->kind.value == CameraKind::Orbit)
    return orbit(*camera, float(width) / float(height));
  View view;
  view.projection = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, -1.0f, 1.0f);
  return view;
}

glm::mat4 toTexture(const View &view) {
  const glm::mat4 half =
      glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(0.5f));
  return half * view.projection * view.modelView;
}

} // namespace arbiter::scene
