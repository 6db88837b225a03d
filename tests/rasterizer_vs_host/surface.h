#pragma once
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// What the clients of this folder draw on. They know nothing of Arbiter: run.py draws each scene
/// on the bare host and with the layer in front, and compares.
namespace software {

/// An X display with one configuration: RGBA8, 24 bits of depth, 8 of stencil, double buffered.
class Screen {
public:
  /// False, after a message, without a display or configuration.
  [[nodiscard]] bool open();
  [[nodiscard]] GLXDrawable makeWindow(int width, int height);
  [[nodiscard]] GLXDrawable makePbuffer(int width, int height);
  [[nodiscard]] GLXContext makeContext(GLXContext share = nullptr);
  void makeCurrent(GLXDrawable drawable, GLXContext context);
  void destroy(GLXContext context);
  void swap(GLXDrawable drawable);
  /// What the window shows, RGBA8 with an alpha of 255, bottom row first.
  [[nodiscard]] std::vector<unsigned char> grab(int width, int height);

private:
  Display *m_display = nullptr;
  GLXFBConfig m_config = nullptr;
  Window m_window = 0; ///< the last that was made
};

/// What a client of random scenes does: for each of COUNT seeds from SEED on, its arguments,
/// `draw(seed, screen, window, option)` in a window of `edge` pixels a side.
/// \param option what a third argument may be; the last parameter says whether it is there
template <typename Draw>
int drawSeeds(int argc, char **argv, int edge, const char *option, Draw draw) {
  const bool chosen = argc == 4 && option && std::string(argv[3]) == option;
  if (argc != 3 && !chosen)
    return 2;
  Screen screen;
  if (!screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(edge, edge);
  const int first = std::atoi(argv[1]), count = std::atoi(argv[2]);
  for (int seed = first; seed < first + count; ++seed)
    draw(seed, screen, window, chosen);
  return 0;
}

/// Writes `text` as one line and then the bytes to standard output: what run.py reads.
void record(const std::string &text, const std::vector<unsigned char> &bytes);
/// The read framebuffer's rectangle as RGBA8.
[[nodiscard]] std::vector<unsigned char> readRgba(int x, int y, int width, int height);
/// GL errors since the last call, in order, as text.
[[nodiscard]] std::string takeErrors();

/// A program of either target; aborts if GL rejects it, since then nothing would be tested.
[[nodiscard]] GLuint makeProgram(GLenum target, const std::string &text);

/// A generator that is the same everywhere: splitmix64.
class Random {
public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t bits();
  /// 0 to count - 1.
  int below(int count) { return int(bits() % std::uint64_t(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  /// From low on and below high, in a million steps.
  float real(float low, float high) {
    return low + (high - low) * float(below(1 << 20)) / float(1 << 20);
  }
  /// true once in `of` times.
  bool once(int of) { return below(of) == 0; }
  template <typename Range> auto pick(const Range &range) {
    return range[std::size_t(below(int(std::size(range))))];
  }

private:
  std::uint64_t m_state;
};

} // namespace software
