#include "common/demo.h"
#include "common/pictures.h"
#include "common/program.h"
#include "common/texture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace demos {
namespace {

/// The value of no displacement: the maximum, 65535, is odd and cannot be halved exactly.
constexpr int kZero = 32768;

/// Makes the displacement of each texel in 16-bit red and green: kZero for none, 65535 for almost
/// half of the picture.
std::vector<std::uint16_t> makeDisplacement(int width, int height) {
  constexpr float kRadius = 0.47f, kTurn = 4.5f;
  std::vector<std::uint16_t> texels(2ull * width * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 from((float(x) + 0.5f) / float(width) - 0.5f,
                           (float(y) + 0.5f) / float(height) - 0.5f);
      const float inside = std::max(0.0f, 1.0f - glm::length(from) / kRadius);
      const float angle = kTurn * inside * inside;
      const float c = std::cos(angle), s = std::sin(angle);
      const glm::vec2 moved = glm::vec2(c * from.x - s * from.y, s * from.x + c * from.y) - from;
      const std::size_t at = 2 * (std::size_t(y) * width + x);
      for (int i = 0; i < 2; ++i)
        texels[at + i] =
            std::uint16_t(std::lround(std::clamp(moved[i], -0.5f, 0.4999f) * 65535.0f) + kZero);
    }
  }
  return texels;
}

/// Demonstrates a dependent read: the displacement is a texture, made once; the program only adds
/// it.
class Twirl final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "twirl"; }
  [[nodiscard]] std::string summary() const override {
    return "Twirls a picture by a displacement texture and a dependent texture read.";
  }
  [[nodiscard]] std::vector<Slider *> sliders() override { return {&m_amount}; }
  // Filtering weights have 8 bits on common hardware, so that the error is up to 1/256 of an edge
  // on each axis.
  [[nodiscard]] Tolerance tolerance() const override { return {4}; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override {
    m_picture = makeLandscape(surface.width(), surface.height());
    m_displacement = makeDisplacement(surface.width(), surface.height());
    m_gl.emplace();
    m_gl->picture.create2d(m_picture, Filter::Linear, Wrap::Clamp);
    m_gl->displacement.create2dPairs16(surface.width(), surface.height(), m_displacement);
    return m_gl->program.load("twirl.fp", options.program);
  }
  void draw(const Surface &, int frame) override {
    const float scale = amount(frame);
    m_gl->picture.bind(0);
    m_gl->displacement.bind(1);
    m_gl->program.use();
    m_gl->program.local(0, {scale, -scale * float(kZero) / 65535.0f, 0, 0});
    drawQuad();
    Program::disable();
  }
  [[nodiscard]] Image reference(int width, int height, int frame) override {
    const float scale = amount(frame);
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t at = 2 * (std::size_t(y) * width + x);
        const glm::vec2 moved =
            glm::vec2(m_displacement[at] - kZero, m_displacement[at + 1] - kZero);
        image.set(x, y,
                  m_picture.sampleLinear(image.coordinate(x, y) + moved * (scale / 65535.0f)));
      }
    }
    return image;
  }
  void stop() override { m_gl.reset(); }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    return {m_gl->program.countsAsJson()};
  }

private:
  [[nodiscard]] float amount(int frame) const {
    return m_amount.value * std::cos(float(frame) * 0.02f);
  }

  struct Objects {
    Texture picture;
    Texture displacement;
    Program program;
  };
  Slider m_amount{"amount", "how far to twirl; negative: the other way", 1.0f, -1.0f, 1.0f, 0.05f};
  Image m_picture;
  std::vector<std::uint16_t> m_displacement;
  std::optional<Objects> m_gl;
};

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::Twirl demo;
  return demos::run(demo, argc, argv);
}
