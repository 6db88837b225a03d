#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "apps/scene/document.h"
#include "apps/tools/draw/renderer.h"
#include "apps/tools/render/canvas.h"
#include "control/message.h"

namespace arbiter::tools {

/// Draws one document at its time. All calls must come from the thread on which GL is current.
class Player {
public:
  /// \param folder base folder of names in documents
  explicit Player(std::string folder) : m_folder(std::move(folder)) {}

  /// A document from a client.
  struct Text {
    std::string name, text;
    std::map<std::string, std::string> files; ///< files that are open in the editor, by name
    std::int64_t revision = 0;
  };
  /// Replaces the document if the new one is valid; otherwise the previous one stays. The answer
  /// contains the errors (docs/write/control.md, scene.set).
  [[nodiscard]] control::Json set(const Text &text);

  [[nodiscard]] bool hasScene() const { return m_renderer != nullptr; }
  [[nodiscard]] std::int64_t revision() const { return m_revision; }
  /// True if the next frame differs from the last one without any change.
  [[nodiscard]] bool isAnimated() const { return m_animated; }
  [[nodiscard]] double framesPerSecond() const;

  struct ParameterValue {
    bool vertex = false;
    scene::Setting space = scene::Setting::Local;
    unsigned index = 0;
    std::size_t pass = 0;
    std::array<std::optional<float>, 4> value;
  };
  /// Sets a parameter. False if the scene has no such pass or program.
  [[nodiscard]] bool setParameter(const ParameterValue &value);
  /// Sets the picture's size; 0 restores the document's own.
  [[nodiscard]] bool setSize(int width, int height);
  struct Orbit {
    double yaw = 0, pitch = 0, distance = 1;
  };
  /// Turns the document's camera; without an orbit, restores it.
  void setCamera(const std::optional<Orbit> &orbit);
  void setSeconds(double seconds);

  // --- Requires hasScene() ---

  [[nodiscard]] int width() const { return m_document->width(); }
  [[nodiscard]] int height() const { return m_document->height(); }
  [[nodiscard]] int frame() const { return m_frame; }
  /// True if the picture depends on earlier frames.
  [[nodiscard]] bool hasFeedback() const { return m_document->hasFeedback(); }
  /// Returns the number of frames drawn since the document began, which feedback has accumulated.
  [[nodiscard]] int steps() const { return m_steps; }
  /// For a document with feedback: draws frames until the next one is that step. Begins anew if the
  /// step is already past. Stops at the time `until`; steps() tells the result. False if the
  /// document cannot begin anew.
  [[nodiscard]] bool approachStep(int step, std::chrono::steady_clock::time_point until);
  [[nodiscard]] double seconds() const { return m_document->secondsOf(m_frame); }
  void advance(int frames) { m_frame += frames; }
  /// Draws the frame, and reads it into rows of `width() * 4` bytes unless `pixels` is null.
  /// \returns the time in ms
  double draw(std::uint8_t *pixels);

private:
  [[nodiscard]] scene::Document assembled(const Text &text) const;
  [[nodiscard]] bool build(std::unique_ptr<scene::Document> document, RenderError &error);
  void applyCamera(scene::Document &document) const;

  std::string m_folder;
  Canvas m_canvas;
  Text m_text;
  // The document must outlive the renderer.
  std::unique_ptr<scene::Document> m_document;
  std::unique_ptr<Renderer> m_renderer;
  std::int64_t m_revision = 0;
  int m_frame = 0;
  int m_steps = 0;
  bool m_animated = false;
  int m_width = 0, m_height = 0; ///< replaces the document's size; 0: not set
  std::optional<Orbit> m_orbit;
};

} // namespace arbiter::tools
