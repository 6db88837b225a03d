#include "common/demo.h"
#include "common/pictures.h"
#include "common/program.h"
#include "common/texture.h"

#include <optional>

namespace demos {
namespace {

/// Writes one sample to the framebuffer unchanged; the other demos start from this.
class PassThrough final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "pass-through"; }
  [[nodiscard]] std::string summary() const override {
    return "Draws a picture through a fragment program of one instruction.";
  }
  [[nodiscard]] std::vector<std::string> forms() const override { return {"nearest", "linear"}; }
  // A nearest sample of an 8-bit texel, written to 8 bits, is that texel. A linear one at its
  // center is too, except for the rounding of the coordinate, which may cost a level on some hosts.
  [[nodiscard]] Tolerance tolerance() const override { return {m_linear ? 1 : 0}; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override {
    m_picture = makeLandscape(surface.width(), surface.height());
    m_linear = options.form == "linear";
    m_gl.emplace();
    m_gl->texture.create2d(m_picture, m_linear ? Filter::Linear : Filter::Nearest, Wrap::Clamp);
    return m_gl->program.load("pass_through.fp", options.program);
  }
  void draw(const Surface &, int) override {
    m_gl->texture.bind(0);
    m_gl->program.use();
    drawQuad();
    Program::disable();
  }
  [[nodiscard]] Image reference(int, int, int) override { return m_picture; }
  void stop() override { m_gl.reset(); }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    return {m_gl->program.countsAsJson()};
  }

private:
  struct Objects {
    Texture texture;
    Program program;
  };
  Image m_picture;
  bool m_linear = false;
  std::optional<Objects> m_gl;
};

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::PassThrough demo;
  return demos::run(demo, argc, argv);
}
