#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/client_pixels/plain_transfer.h"

/// Pixels of the host's, read and written for clients and for figures in the frame. What state that
/// needs otherwise than the application left it is put back at the end; no name of the
/// application's is bound, made or deleted. Compatibility contexts, current, outside Begin and
/// lists.
namespace arbiter::state {

class Context;

namespace remote {

/// RGBA bytes, bottom row first, no gap between rows.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Made smaller by whole steps, each pixel the mean of a square, until no side is above the limit
/// (0: any).
[[nodiscard]] Picture reduced(Picture picture, int maxWidth, int maxHeight);

/// The size of the current drawable, from the window system. False: it is not known.
[[nodiscard]] bool drawableSize(const Context &context, int &width, int &height);

/// What the frame shows so far: the drawable's back buffer, or front where there is no other.
/// \returns an empty picture where it cannot be read, with `why`.
[[nodiscard]] Picture readDrawable(Context &context, const char *&why);

/// What is bound to a target of a texture unit.
struct BoundTexture {
  GLint name = 0;
  GLuint unit = 0;
  std::size_t target = 0;                             ///< row of textureTargets()
  GLint width = 0, height = 0, depth = 0, format = 0; ///< of level 0; 0: no image
};
struct TextureTarget {
  const char *word;
  GLenum target, query, image; ///< image: whose level 0 is asked for, of a cube its first face
};
[[nodiscard]] const std::array<TextureTarget, 5> &textureTargets();
/// Every texture that is bound with a name, by unit; each target's texture of the name 0 once, if
/// it has an image.
[[nodiscard]] std::vector<BoundTexture> boundTextures(Context &context);
/// Level 0, or of a cube its first face, of a volume its first slice, with the colours that a
/// sampler has. Empty with `why` where it cannot be read.
[[nodiscard]] Picture readTexture(Context &context, const BoundTexture &texture, const char *&why);
/// All levels of a two-dimensional texture that has the picture's size: the picture, and smaller
/// ones made of it as far as the texture has levels. False with `why`.
[[nodiscard]] bool writeTexture(Context &context, const BoundTexture &texture,
                                const Picture &picture, const char *&why);

} // namespace remote
} // namespace arbiter::state
