#pragma once
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// The windows and helpers of this folder's clients. They know nothing of Arbiter: run.py draws
/// each scene on the bare host and with the layer in front, and compares.
namespace software {

/// An X display with one configuration: RGBA8, 24 bits of depth, 8 of stencil, double buffered.
class Screen {
public:
  /// Returns false, after a message, without a display or configuration.
  [[nodiscard]] bool open();
  [[nodiscard]] GLXDrawable makeWindow(int width, int height);
  [[nodiscard]] GLXDrawable makePbuffer(int width, int height);
  [[nodiscard]] GLXContext makeContext(GLXContext share = nullptr);
  void makeCurrent(GLXDrawable drawable, GLXContext context);
  void destroy(GLXContext context);
  void swap(GLXDrawable drawable);
  /// Returns the window's visible content, RGBA8 with an alpha of 255, bottom row first.
  [[nodiscard]] std::vector<unsigned char> grab(int width, int height);

private:
  Display *m_display = nullptr;
  GLXFBConfig m_config = nullptr;
  Window m_window = 0; ///< the last one made
};

/// Runs a client of random scenes: for each of COUNT seeds from SEED on, its arguments, it calls
/// `draw(seed, screen, window, option)` in a window of `edge` pixels a side.
/// \param option a possible third argument; the last parameter says whether it is present
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

/// Returns the row of `rows` whose `name` is the client's first argument; null if there is none.
/// With
/// --list in its place it prints all names and ends the process.
template <typename Rows>
auto rowNamed(const Rows &rows, int argc, char **argv) -> decltype(&*std::begin(rows)) {
  const std::string_view wanted = argc > 1 ? argv[1] : "";
  for (const auto &row : rows) {
    if (wanted == "--list")
      std::printf("%s\n", row.name);
    else if (wanted == row.name)
      return &row;
  }
  if (wanted == "--list")
    std::exit(0);
  return nullptr;
}

/// Runs the row that rowNamed() returns. Returns the client's exit status.
template <typename Rows> int runNamed(const Rows &rows, int argc, char **argv) {
  const auto *const row = rowNamed(rows, argc, argv);
  if (!row)
    return 1;
  row->run();
  return 0;
}

/// Writes `text` as one line and then the bytes to standard output, for run.py.
void record(const std::string &text, const std::vector<unsigned char> &bytes);
/// Returns the read framebuffer's rectangle as RGBA8.
[[nodiscard]] std::vector<unsigned char> readRgba(int x, int y, int width, int height);
/// Returns GL errors since the last call, in order, as text.
[[nodiscard]] std::string takeErrors();

/// Makes a program of either target; aborts if GL rejects it, as nothing would be tested then.
[[nodiscard]] GLuint makeProgram(GLenum target, const std::string &text);

/// Makes and binds a framebuffer, whose color is the 2D texture if one is given.
GLuint makeFramebuffer(GLuint texture = 0);
/// Attaches a new renderbuffer to the bound framebuffer, and returns it.
GLuint attachBuffer(GLenum attachment, GLenum format, int width, int height);

/// A random generator that is the same everywhere: splitmix64.
class Random {
public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t bits();
  /// Returns a number from 0 to count - 1.
  int below(int count) { return int(bits() % std::uint64_t(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  /// Returns a number from low on and below high, in a million steps.
  float real(float low, float high) {
    return low + (high - low) * float(below(1 << 20)) / float(1 << 20);
  }
  /// Returns true once in `of` times.
  bool once(int of) { return below(of) == 0; }
  template <typename Range> auto pick(const Range &range) {
    return range[std::size_t(below(int(std::size(range))))];
  }

private:
  std::uint64_t m_state;
};

} // namespace software
