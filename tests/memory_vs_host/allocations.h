#pragma once
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <epoxy/glx.h>

/// The scenes of rasterizer-allocations: GL commands that need memory of the layer, each followed
/// by commands that show whether it worked.
namespace memory {

inline constexpr int kSide = 48; ///< pixels on a side of the window

/// A window with its current context. If a GLX function fails, `refused` is set.
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

/// A frame that is drawn repeatedly, with another `round` each time. It must not affect the next
/// one. The caller takes GL's errors.
struct Scene {
  const char *name;
  void (*prepare)(Surface &window); ///< called once, with all memory; null: nothing
  Pixels (*frame)(Surface &window, int round);
};
extern const std::vector<Scene> kScenes;

[[nodiscard]] Pixels readPixels();
/// Sets the state that frames begin with.
void reset();

} // namespace memory
