#pragma once
#include "common/image.h"
#include "common/surface.h"
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace demos {

/// A value that keys change in a window and an option of the same name sets.
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
  std::string reference; ///< a file for what verify compares the last frame with
  std::string program;   ///< a file that replaces the built-in text
  bool headless = false;
  bool pbuffer = false;
  bool verify = false;
  bool bench = false;
  bool paced = false;
  bool info = false;
  std::string form; ///< one of Demo::forms()
};

/// The part that is specific to one demo.
class Demo {
public:
  virtual ~Demo() = default;
  Demo() = default;
  Demo(const Demo &) = delete;
  Demo &operator=(const Demo &) = delete;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string summary() const = 0;
  /// Returns extra lines for --help: the functions of the mouse and of further keys.
  [[nodiscard]] virtual std::string controls() const { return {}; }
  /// Returns the ways of making the same picture; the first one is the default.
  [[nodiscard]] virtual std::vector<std::string> forms() const { return {}; }
  [[nodiscard]] virtual std::vector<Slider *> sliders() { return {}; }
  [[nodiscard]] virtual Tolerance tolerance() const = 0;
  [[nodiscard]] virtual int verifyFrames() const { return 1; }
  /// Returns the width and height without --size.
  [[nodiscard]] virtual int side() const { return 1024; }
  /// Returns how many frames --out draws to have something to show.
  [[nodiscard]] virtual int pictureFrames() const { return 1; }

  /// Makes the textures and programs. Returns false after a message on stderr.
  [[nodiscard]] virtual bool start(const Surface &surface, const Options &options) = 0;
  /// Draws frame number \p frame, from 0; frames come in order.
  virtual void draw(const Surface &surface, int frame) = 0;
  /// Computes the frame's picture in plain C++. Frames come in order, each after its draw().
  [[nodiscard]] virtual Image reference(int width, int height, int frame) = 0;
  /// Deletes what start() made, while the context is still current.
  virtual void stop() = 0;
  /// Returns false if drawing a frame again changes the picture.
  [[nodiscard]] virtual bool redrawsWhilePaused() const { return true; }
  /// Returns JSON objects, one for each program, for --info.
  [[nodiscard]] virtual std::vector<std::string> programCounts() const = 0;

  /// Handles the pointer with its button down, in [0,1] from the lower left.
  virtual void pointer(glm::vec2) {}
  /// Handles a key that no slider uses, as its upper-case letter.
  virtual void key(char) {}
};

inline constexpr int kExitOk = 0;
inline constexpr int kExitFailed = 1;
/// The host lacks a feature; meson's code for a skipped test
inline constexpr int kExitSkipped = 77;

/// Runs a demo; main() consists of this call.
[[nodiscard]] int run(Demo &demo, int argc, char **argv);

/// Fills \p options and the sliders from the command line. Returns false if the process is to end
/// with \p exitCode, after --help or an invalid option.
[[nodiscard]] bool parseOptions(Demo &demo, int argc, char **argv, Options &options, int &exitCode);

/// Draws and shows frames until the window is closed or \p frames (if not 0) are done.
void runWindow(Demo &demo, Surface &surface, int frames);

/// Draws a quad over the whole viewport. Texture coordinate set 0 runs from 0 to 1; each further
/// set is set 0 plus its offset.
void drawQuad(const std::vector<glm::vec2> &offsets = {});

} // namespace demos
