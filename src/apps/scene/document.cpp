#include "apps/scene/document.h"

#include <algorithm>

#include "fp_compiler/hw/profile.h"

namespace arbiter::scene {

std::string profileOf(const Panel &panel, const std::string &folder) {
  return fp::hw::isProfileFile(panel.profile.text) ? folder + panel.profile.text
                                                   : panel.profile.text;
}

bool Document::ok() const {
  return std::all_of(files.begin(), files.end(),
                     [](const ProgramFile &file) { return file.panel.ok(); });
}

const std::vector<ShapeSpec> &Document::meshOf(const Pass &pass) const {
  const auto &own = panelOf(pass).mesh;
  return own.empty() ? panel().mesh : own;
}

const std::optional<CameraSpec> &Document::cameraOf(const Pass &pass) const {
  const auto &own = panelOf(pass).camera;
  return own ? own : panel().camera;
}

std::pair<int, int> Document::sizeOf(const Pass &pass) const {
  if (const auto &target = panelOf(pass).target)
    return {int(target->width.value), int(target->height.value)};
  return {width(), height()};
}

View Document::viewOf(const Pass &pass) const {
  const auto [columns, rows] = sizeOf(pass);
  return scene::viewOf(cameraOf(pass), columns, rows);
}

Depth Document::depthOf(const Pass &pass) const {
  if (const auto &depth = panelOf(pass).state.depth)
    return depth->value;
  const auto &camera = cameraOf(pass);
  const auto isFlat = [](const ShapeSpec &spec) {
    return spec.shape.value == Shape::Quad || spec.shape.value == Shape::Grid;
  };
  const auto &mesh = meshOf(pass);
  const bool flat = std::all_of(mesh.begin(), mesh.end(), isFlat);
  const bool seen = camera && camera->kind.value == CameraKind::Orbit;
  return flat && !seen ? Depth::Off : Depth::Less;
}

bool Document::clears(std::size_t index) const { return !panelOf(passes[index]).state.keep; }

std::vector<ParameterRow> Document::rows(const Pass &pass, int file, double seconds) const {
  const auto viewOfTarget = [&](const std::string &name) -> std::optional<View> {
    for (const Pass &other : passes)
      if (const auto &target = panelOf(other).target; target && target->name.text == name)
        return viewOf(other);
    return std::nullopt;
  };
  return rowsAt(files[std::size_t(file)].panel, seconds, {viewOf(pass), viewOfTarget});
}

bool Document::hasFeedback() const {
  const auto feeds = [](const TextureSpec &texture) {
    return texture.source.generator.value == Generator::Feedback;
  };
  return std::any_of(passes.begin(), passes.end(), [&](const Pass &pass) {
    const auto &textures = panelOf(pass).textures;
    return std::any_of(textures.begin(), textures.end(), feeds);
  });
}

} // namespace arbiter::scene
