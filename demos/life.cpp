#include "common/demo.h"
#include "common/program.h"
#include "common/texture.h"

#include <algorithm>
#include <optional>

namespace demos {
namespace {

/// A board on a torus, by the plain rule; both programs are compared with it.
class Board {
public:
  Board(int width, int height)
      : m_width(width), m_height(height), m_cells(area()), m_trail(area()) {
    // The board starts with three r-pentominoes, far enough apart to grow before they meet.
    static constexpr int kShape[5][2] = {{0, 1}, {1, 1}, {-1, 0}, {0, 0}, {0, -1}};
    static constexpr float kPlaces[3][2] = {{0.32f, 0.36f}, {0.70f, 0.42f}, {0.47f, 0.70f}};
    for (int i = 0; i < 3; ++i) {
      // The shapes are as they are, mirrored, and upside down.
      const int flipX = i == 1 ? -1 : 1, flipY = i == 2 ? -1 : 1;
      for (const auto &cell : kShape)
        m_cells[index(int(kPlaces[i][0] * float(width)) + flipX * cell[0],
                      int(kPlaces[i][1] * float(height)) + flipY * cell[1])] = 1;
    }
    for (std::size_t i = 0; i < area(); ++i)
      m_trail[i] = m_cells[i] ? 255 : 0;
  }

  [[nodiscard]] bool alive(int x, int y) const { return m_cells[index(x, y)]; }
  /// Returns the number of live cells in the three by three around (x, y), including itself.
  [[nodiscard]] int around(int x, int y) const {
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        count += alive(x + dx, y + dy);
    return count;
  }
  /// Returns 255 for a live cell, and 8 less for each generation since.
  [[nodiscard]] int trail(int x, int y) const { return m_trail[index(x, y)]; }

  void step() {
    std::vector<std::uint8_t> next(m_cells.size());
    for (int y = 0; y < m_height; ++y) {
      for (int x = 0; x < m_width; ++x) {
        const bool self = alive(x, y);
        const int neighbours = around(x, y) - int(self);
        const bool lives = neighbours == 3 || (self && neighbours == 2);
        next[index(x, y)] = lives;
        int &trail = m_trail[index(x, y)];
        trail = lives ? 255 : std::max(0, trail - 8);
      }
    }
    m_cells.swap(next);
  }

private:
  [[nodiscard]] std::size_t area() const { return std::size_t(m_width) * m_height; }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return std::size_t((y + m_height) % m_height) * m_width + (x + m_width) % m_width;
  }

  int m_width;
  int m_height;
  std::vector<std::uint8_t> m_cells;
  std::vector<int> m_trail;
};

glm::vec4 white(bool on) { return glm::vec4(on ? 1.0f : 0.0f); }

/// Returns the rule as a color: red is the cell's next state, the rest is for display.
glm::vec4 ruleColor(bool self, int around) {
  const int neighbours = around - int(self);
  if (neighbours == 3 && !self)
    return {1.0f, 0.8f, 0.2f, 1.0f}; // born: gold
  if (self && (neighbours == 2 || neighbours == 3))
    return glm::vec4(1.0f); // stays: white
  if (self)
    return {0.0f, 0.4f, 0.8f, 1.0f}; // dies: blue
  return {0.0f, 0.0f, 0.0f, 1.0f};
}

/// Plays the Game of Life by texture feedback: the drawn picture is copied into the texture that
/// the next generation reads.
class Life final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "life"; }
  [[nodiscard]] std::string summary() const override {
    return "Conway's Game of Life from three r-pentominoes, by texture feedback.\n"
           "naive: one program of 36 instructions, 9 of them texture samples.\n"
           "packed: three cells a texel and the rule in a table: 4 samples.";
  }
  [[nodiscard]] std::string controls() const override { return "  R  start again\n"; }
  [[nodiscard]] std::vector<std::string> forms() const override { return {"naive", "packed"}; }
  // Every value is a multiple of 1/255 or far from the middle of two, so that rounding cannot
  // differ.
  [[nodiscard]] Tolerance tolerance() const override { return {}; }
  [[nodiscard]] int verifyFrames() const override { return 64; }
  [[nodiscard]] int side() const override { return 512; }
  [[nodiscard]] int pictureFrames() const override { return 600; }
  [[nodiscard]] bool redrawsWhilePaused() const override { return false; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override {
    m_packed = options.form == "packed";
    m_gl.emplace();
    restart(surface.width(), surface.height());
    if (!m_packed)
      return m_gl->rule.load("life_naive.fp", options.program);
    makeTable();
    return m_gl->rule.load("life_packed.fp", options.program) && m_gl->pack.load("life_pack.fp");
  }
  void draw(const Surface &surface, int) override {
    if (m_startAgain)
      restart(surface.width(), surface.height());
    glReadBuffer(surface.colorBuffer());
    if (m_packed)
      drawPacked(surface.width(), surface.height());
    else
      drawNaive(surface.width(), surface.height());
    Program::disable();
  }
  [[nodiscard]] Image reference(int width, int height, int) override;
  void stop() override { m_gl.reset(); }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    if (!m_packed)
      return {m_gl->rule.countsAsJson()};
    return {m_gl->rule.countsAsJson(), m_gl->pack.countsAsJson()};
  }
  void key(char letter) override { m_startAgain |= letter == 'R'; }

private:
  struct Objects {
    Texture cells;  ///< red is the cell
    Texture packed; ///< west, self, east
    Texture table;
    Program rule;
    Program pack;
  };

  void restart(int width, int height) {
    m_startAgain = false;
    m_board.emplace(width, height);
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.set(x, y, white(m_board->alive(x, y)));
    m_gl->cells.create2d(image, Filter::Nearest, Wrap::Repeat);
    if (m_packed)
      m_gl->packed.create2d(image, Filter::Nearest, Wrap::Repeat);
  }
  void makeTable() {
    Image table(2, 16);
    for (int around = 0; around < table.height; ++around)
      for (int self = 0; self < table.width; ++self)
        table.set(self, around, ruleColor(self != 0, around));
    m_gl->table.create2d(table, Filter::Nearest, Wrap::Clamp);
  }
  void drawNaive(int width, int height) {
    const float dx = 1.0f / float(width), dy = 1.0f / float(height);
    m_gl->cells.bind(0);
    m_gl->rule.use();
    m_gl->rule.local(0, {dx, dy, -dx, 0});
    drawQuad();
    m_gl->cells.copyFromFramebuffer(0, width, height);
  }
  void drawPacked(int width, int height) {
    const float dx = 1.0f / float(width), dy = 1.0f / float(height);
    m_gl->cells.bind(0);
    m_gl->pack.use();
    drawQuad({{-dx, 0}, {dx, 0}});
    m_gl->packed.copyFromFramebuffer(0, width, height);
    m_gl->table.bind(1);
    m_gl->rule.use();
    drawQuad({{0, dy}, {0, -dy}});
    m_gl->cells.copyFromFramebuffer(0, width, height);
  }

  bool m_packed = false;
  bool m_startAgain = false;
  std::optional<Board> m_board;
  std::optional<Objects> m_gl;
};

Image Life::reference(int width, int height, int) {
  Image image(width, height);
  const Board before = *m_board;
  m_board->step();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      glm::vec4 color = white(m_board->alive(x, y));
      if (m_packed)
        color = ruleColor(before.alive(x, y), before.around(x, y));
      else
        color.y = color.z = float(m_board->trail(x, y)) / 255.0f;
      image.set(x, y, color);
    }
  }
  return image;
}

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::Life demo;
  return demos::run(demo, argc, argv);
}
