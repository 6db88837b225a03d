#pragma once
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include "programs.h"

/// Path equality: small scenes that go the ways GL has around a program. A case draws and writes
/// down what it saw; run.py runs it on the bare host and under the layer and compares.
namespace paths {

using namespace api;

/// The edge of every picture, in pixels.
inline constexpr int kSize = 64;

/// What a case hands to the comparison.
class Recorder {
public:
  /// The read framebuffer's lower left kSize x kSize pixels, RGBA8.
  void picture(const std::string &what);
  /// A number that is the same on both sides.
  void value(const std::string &what, double number);
  /// GetError until there is none; in order.
  void errors(const std::string &what);
  /// What the specification asks for, with and without the layer.
  void check(bool holds, const std::string &what);
  /// A pixel's colour, within 2 of 255.
  void pixel(const std::string &what, int x, int y, Pixel wanted);
  /// The case needs what this context lacks.
  void skip(const std::string &why) { m_skipped = why; }

  /// One line of JSON; the pictures go to `folder`.
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
  /// Where the bare host (Mesa 22.3.6) is wrong: how. Its own checks may fail then, and nothing is
  /// compared with it.
  const char *bareHost = nullptr;
};

/// The tables, one a file.
extern const std::vector<Case> kListCases, kListStateCases, kNestedListCases, kSharedCases,
    kFramebufferCases, kDrawCases, kGlslCases, kQueryCases, kPixelCases, kCompareCases;

/// A context on the case's drawable, of 64x64 RGBA8 with depth, stencil and accumulation buffers.
GLXContext createContext(GLXContext share = nullptr);
/// The context that each case starts with.
GLXContext mainContext();
void makeCurrent(GLXContext context);
void destroyContext(GLXContext context);
Display *display();

// --- Scenes ---

/// !!ARBvp1.0: position + env[0], colour and texture coordinate 0 passed on.
extern const char kMoveVertices[];
/// !!ARBfp1.0: colour * local[0] + env[0].
extern const char kTintFragments[];
/// Both, loaded, bound and enabled; a tint of ones.
struct Programs {
  GLuint vertex = 0;
  GLuint fragment = 0;
};
Programs usePrograms();
/// A quad of four colours; corners in clip space.
void gradient(float x0 = -0.9f, float y0 = -0.9f, float x1 = 0.9f, float y1 = 0.9f);
/// A 2D texture, nearest, of size x size texels that all differ; bound to the active unit.
GLuint checkered(int size = 8);
void tint(float r, float g, float b, float a = 1.0f);

} // namespace paths
