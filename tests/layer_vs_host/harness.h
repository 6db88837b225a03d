#pragma once
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include "programs.h"

/// Tests path equality with small scenes that take all paths of GL around a program. A case draws
/// and records the results; run.py runs it on the bare host and under the layer, and compares.
namespace paths {

using namespace api;

/// The width and height of every picture, in pixels.
inline constexpr int kSize = 64;

/// Records a case's results for the comparison.
class Recorder {
public:
  /// Records the read framebuffer's lower left kSize x kSize pixels, RGBA8.
  void picture(const std::string &what);
  /// Records a number that must be equal on both sides.
  void value(const std::string &what, double number);
  /// Records GetError's results until there is none, in order.
  void errors(const std::string &what);
  /// Records a requirement of the specification, with and without the layer.
  void check(bool holds, const std::string &what);
  /// Checks a pixel's color, within 2 of 255.
  void pixel(const std::string &what, int x, int y, Pixel wanted);
  /// Skips the case, as the context lacks something.
  void skip(const std::string &why) { m_skipped = why; }

  /// Writes one line of JSON; the pictures go to `folder`.
  void write(const std::string &name, const std::string &folder) const;

private:
  struct Picture {
    std::string what;
    std::vector<unsigned char> rgba;
  };
  std::vector<Picture> m_pictures;
  std::vector<std::pair<std::string, double>> m_values;
  std::vector<std::string> m_failed;
  std::string m_skipped;
};

struct Case {
  const char *name;
  void (*run)(Recorder &);
  /// The bare host's fault (Mesa 22.3.6), if any. Its own checks may then fail, and nothing is
  /// compared with it.
  const char *bareHost = nullptr;
};

/// The tables, one in each file.
extern const std::vector<Case> kListCases, kListStateCases, kNestedListCases, kSharedCases,
    kFramebufferCases, kDrawCases, kGlslCases, kQueryCases, kPixelCases, kCompareCases;

/// Creates a context on the case's drawable, of 64x64 RGBA8 with depth, stencil and accumulation
/// buffers.
GLXContext createContext(GLXContext share = nullptr);
/// Returns the context that each case starts with.
GLXContext mainContext();
void makeCurrent(GLXContext context);
void destroyContext(GLXContext context);
Display *display();

// --- Scenes ---

/// The text is !!ARBvp1.0: position + env[0]; color and texture coordinate 0 are passed on.
extern const char kMoveVertices[];
/// The text is !!ARBfp1.0: color * local[0] + env[0].
extern const char kTintFragments[];
/// Both programs, loaded, bound and enabled, with a tint of ones.
struct Programs {
  GLuint vertex = 0;
  GLuint fragment = 0;
};
Programs usePrograms();
/// Draws a quad of four colors; the corners are in clip space.
void gradient(float x0 = -0.9f, float y0 = -0.9f, float x1 = 0.9f, float y1 = 0.9f);
/// Makes a 2D texture with nearest sampling and size x size different texels, bound to the active
/// unit.
GLuint checkered(int size = 8);
void tint(float r, float g, float b, float a = 1.0f);

} // namespace paths
