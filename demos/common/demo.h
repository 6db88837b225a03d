#pragma once
#include "common/image.h"
#include "common/surface.h"
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace demos {

/// A value that keys move in a window and an option of the same name sets.
struct Slider {
  std::string name;
  std::string help;
  float value;
  float low;
  float high;
  float step;
};

struct Options {
  int width = 0;
  int height = 0;
  int frames = 0; ///< 0: the demo's own number, or until the window closes
  std::string out;
  std::string program; ///< a file in place of the built-in text
  bool headless = false;
  bool pbuffer = false;
  bool verify = false;
  bool bench = false;
  bool paced = false;
  bool info = false;
  std::string form; ///< one of Demo::forms()
};

/// What one demo adds to the frame around them all.
class Demo {
public:
  virtual ~Demo() = default;
  Demo() = default;
  Demo(const Demo &) = delete;
  Demo &operator=(const Demo &) = delete;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string summary() const = 0;
  /// Extra lines for --help: what the mouse and further keys do.
  [[nodiscard]] virtual std::string controls() const { return {}; }
  /// Ways of making the same picture, the first one by default.
  [[nodiscard]] virtual std::vector<std::string> forms() const { return {}; }
  [[nodiscard]] virtual std::vector<Slider *> sliders() { return {}; }
  [[nodiscard]] virtual Tolerance tolerance() const = 0;
  [[nodiscard]] virtual int verifyFrames() const { return 1; }
  /// Width and height without --size.
  [[nodiscard]] virtual int side() const { return 1024; }
  /// How many frames --out draws to have something to show.
  [[nodiscard]] virtual int pictureFrames() const { return 1; }

  /// Makes the textures and programs. False after a message on stderr.
  [[nodiscard]] virtual bool start(const Surface &surface, const Options &options) = 0;
  /// Draws frame number \p frame, from 0; frames come in order.
  virtual void draw(const Surface &surface, int frame) = 0;
  /// The same picture by plain C++; frames come in order, each after its draw().
  [[nodiscard]] virtual Image reference(int width, int height, int frame) = 0;
  /// Deletes what start() made, while the context is still current.
  virtual void stop() = 0;
  /// False if drawing a frame again is not the same picture.
  [[nodiscard]] virtual bool redrawsWhilePaused() const { return true; }
  /// JSON objects, one a program, for --info.
  [[nodiscard]] virtual std::vector<std::string> programCounts() const = 0;

  /// The pointer with its button down, in [0,1] from the lower left.
  virtual void pointer(glm::vec2) {}
  /// A key that is not a slider's, as its upper-case letter.
  virtual void key(char) {}
};

inline constexpr int kExitOk = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitSkipped = 77; ///< the host cannot: what meson calls a skipped test

/// The whole of a demo's main().
[[nodiscard]] int run(Demo &demo, int argc, char **argv);

/// Fills \p options and the sliders from the command line. Returns false when the process is to end
/// with \p exitCode: after --help, or a wrong option.
[[nodiscard]] bool parseOptions(Demo &demo, int argc, char **argv, Options &options, int &exitCode);

/// Draws and shows frames until the window is closed or \p frames (if not 0) are done.
void runWindow(Demo &demo, Surface &surface, int frames);

/// A quad over the whole viewport. Texture coordinate set 0 runs from 0 to 1; each further set is
/// set 0 plus its offset.
void drawQuad(const std::vector<glm::vec2> &offsets = {});

} // namespace demos
