#include "common/demo.h"
#include "common/pictures.h"
#include "common/program.h"
#include "common/texture.h"

#include <cmath>
#include <optional>

namespace demos {
namespace {

/// Adjusts brightness and contrast by three POWs and a MAD in a fragment program.
class BrightnessContrast final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "brightness-contrast"; }
  [[nodiscard]] std::string summary() const override {
    return "Adjusts a picture's brightness and contrast with three POW instructions.";
  }
  [[nodiscard]] std::vector<Slider *> sliders() override { return {&m_brightness, &m_contrast}; }
  // EX2 and LG2 are approximations. Their error is less than one level, which may round to two.
  [[nodiscard]] Tolerance tolerance() const override { return {2}; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override {
    m_picture = makeLandscape(surface.width(), surface.height());
    m_gl.emplace();
    m_gl->texture.create2d(m_picture, Filter::Nearest, Wrap::Clamp);
    return m_gl->program.load("brightness_contrast.fp", options.program);
  }
  void draw(const Surface &, int) override {
    m_gl->texture.bind(0);
    m_gl->program.use();
    m_gl->program.local(0, level());
    drawQuad();
    Program::disable();
  }
  [[nodiscard]] Image reference(int width, int height, int) override {
    const glm::vec4 knobs = level();
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        glm::vec4 color = m_picture.at(x, y);
        for (int i = 0; i < 3; ++i)
          color[i] = std::pow(color[i], knobs.x) * knobs.y + knobs.z;
        image.set(x, y, color);
      }
    }
    return image;
  }
  void stop() override { m_gl.reset(); }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    return {m_gl->program.countsAsJson()};
  }

private:
  [[nodiscard]] glm::vec4 level() const {
    return {1.0f / m_brightness.value, m_contrast.value, 0.5f - 0.5f * m_contrast.value, 0.0f};
  }

  struct Objects {
    Texture texture;
    Program program;
  };
  Slider m_brightness{
      "brightness", "the power of the middle tones: 1 leaves them", 1.4f, 0.2f, 5.0f, 0.05f};
  Slider m_contrast{"contrast", "the stretch about middle grey: 1 leaves it", 1.25f, 0.0f, 4.0f,
                    0.05f};
  Image m_picture;
  std::optional<Objects> m_gl;
};

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::BrightnessContrast demo;
  return demos::run(demo, argc, argv);
}
