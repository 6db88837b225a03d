#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "control/message.h"
#include "scene/document.h"
#include "tools/draw/renderer.h"
#include "tools/render/canvas.h"

namespace arbiter::tools {

/// One document that is drawn, and its time. Everything is called on the thread that GL is current
/// on.
class Player {
public:
  /// \param folder that names in documents begin from
  explicit Player(std::string folder) : m_folder(std::move(folder)) {}

  /// What a client sends.
  struct Text {
    std::string name, text;
    std::map<std::string, std::string> files; ///< that an editor has open, by name
    std::int64_t revision = 0;
  };
  /// Takes the document's place that was drawn, where it is right: what is wrong is in the answer
  /// (docs/write/control.md, scene.set), and the one before goes on.
  [[nodiscard]] control::Json set(const Text &text);

  [[nodiscard]] bool hasScene() const { return m_renderer != nullptr; }
  [[nodiscard]] std::int64_t revision() const { return m_revision; }
  /// The next frame differs from the last one though nothing was changed.
  [[nodiscard]] bool isAnimated() const { return m_animated; }
  [[nodiscard]] double framesPerSecond() const;

  struct ParameterValue {
    bool vertex = false;
    scene::Setting space = scene::Setting::Local;
    unsigned index = 0;
    std::size_t pass = 0;
    std::array<std::optional<float>, 4> value;
  };
  /// False: the scene has no such pass or program.
  [[nodiscard]] bool setParameter(const ParameterValue &value);
  /// 0: the document's own size.
  [[nodiscard]] bool setSize(int width, int height);
  struct Orbit {
    double yaw = 0, pitch = 0, distance = 1;
  };
  /// Turns the document's camera; nothing gives it back.
  void setCamera(const std::optional<Orbit> &orbit);
  void setSeconds(double seconds);

  // --- Requires hasScene() ---

  [[nodiscard]] int width() const { return m_document->width(); }
  [[nodiscard]] int height() const { return m_document->height(); }
  [[nodiscard]] int frame() const { return m_frame; }
  /// The picture follows from those before.
  [[nodiscard]] bool hasFeedback() const { return m_document->hasFeedback(); }
  /// Frames drawn since the document began, each of which feedback has taken up.
  [[nodiscard]] int steps() const { return m_steps; }
  /// Of a document with feedback: draws what is missing until the next frame drawn is that step,
  /// from the beginning where it is beyond it. At most until then: steps() says how far it came.
  /// False: GL has no room to begin anew.
  [[nodiscard]] bool approachStep(int step, std::chrono::steady_clock::time_point until);
  [[nodiscard]] double seconds() const { return m_document->secondsOf(m_frame); }
  void advance(int frames) { m_frame += frames; }
  /// Draws the frame, and reads it where `pixels` is not null: rows of `width() * 4` bytes.
  /// \returns ms that it took
  double draw(std::uint8_t *pixels);

private:
  [[nodiscard]] scene::Document assembled(const Text &text) const;
  [[nodiscard]] bool build(std::unique_ptr<scene::Document> document, RenderError &error);
  void applyCamera(scene::Document &document) const;

  std::string m_folder;
  Canvas m_canvas;
  Text m_text;
  // The document outlives what draws it.
  std::unique_ptr<scene::Document> m_document;
  std::unique_ptr<Renderer> m_renderer;
  std::int64_t m_revision = 0;
  int m_frame = 0;
  int m_steps = 0;
  bool m_animated = false;
  int m_width = 0, m_height = 0; ///< in place of the document's
  std::optional<Orbit> m_orbit;
};

} // namespace arbiter::tools
