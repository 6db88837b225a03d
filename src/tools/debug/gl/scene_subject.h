#pragma once
#include "tools/debug/gl/subject.h"
#include "tools/draw/renderer.h"

namespace arbiter::tools::debug {

/// The last frame of a scene as `arbiter draw` draws it.
class SceneSubject : public Subject {
public:
  explicit SceneSubject(Scene scene) : m_scene(std::move(scene)) {}

  [[nodiscard]] std::array<int, 2> size() const override { return {m_scene.width, m_scene.height}; }
  [[nodiscard]] std::optional<DebugError> prepare() override {
    auto prepared = PreparedScene::prepare(m_scene);
    if (!prepared)
      return DebugError{prepared.error().message};
    m_prepared = std::move(prepared).value();
    return {};
  }
  void drawMesh() override { m_prepared->drawMesh(); }
  bool clear() override {
    m_prepared->clear();
    return true;
  }
  void setPlainState() override {}

private:
  Scene m_scene;
  std::unique_ptr<PreparedScene> m_prepared;
};

} // namespace arbiter::tools::debug
