#pragma once
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// What the scenes of rasterizer-allocations draw with: commands of GL that need memory of the
/// layer's, each followed by what shows whether they did what they should.
namespace memory {

inline constexpr int kSide = 48; ///< pixels of an edge of the window

/// A window and its context, made current. Functions of GLX may be refused: then `refused` is set.
struct Surface {
  Display *display = nullptr;
  GLXFBConfig config = nullptr;
  GLXDrawable drawable = 0;
  GLXContext context = nullptr;
  ::Window x = 0;
  bool refused = false;

  [[nodiscard]] bool open();
  [[nodiscard]] bool use(GLXDrawable to, GLXContext with);
};

using Pixels = std::vector<unsigned char>;

/// A frame: made again and again, `round` being another one each time. What it leaves does not
/// matter to the next one. The errors of GL are the caller's to take.
struct Scene {
  const char *name;
  void (*prepare)(Surface &window); ///< once, with all memory there is; null: nothing
  Pixels (*frame)(Surface &window, int round);
};
extern const std::vector<Scene> kScenes;

[[nodiscard]] Pixels readPixels();
/// The state that frames begin with.
void reset();

} // namespace memory
