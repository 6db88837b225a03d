#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/client_pixels/plain_transfer.h"

/// Reads and writes the host's pixels, for clients and for figures in the frame. Restores all state
/// that it changes, and binds, makes or deletes no names of the application's. For compatibility
/// contexts that are current, outside Begin and lists.
namespace arbiter::state {

struct RasterContext;

namespace control {

/// RGBA bytes, bottom row first, without gaps between rows.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Shrinks a picture until no side exceeds the limit (0: any). Each pixel becomes the mean of a
/// square of pixels.
[[nodiscard]] Picture reduced(Picture picture, int maxWidth, int maxHeight);

/// Gets the current drawable's size from the window system. Returns false if it is not known.
[[nodiscard]] bool drawableSize(const RasterContext &context, int &width, int &height);

/// Reads the frame so far: the drawable's back buffer, or its front buffer if it has no other.
/// \returns an empty picture and `why` if it cannot be read
[[nodiscard]] Picture readDrawable(RasterContext &context, const char *&why);

/// A texture that is bound to a target of a unit.
struct BoundTexture {
  GLint name = 0;
  GLuint unit = 0;
  std::size_t target = 0;                             ///< row of textureTargets()
  GLint width = 0, height = 0, depth = 0, format = 0; ///< of level 0; 0: no image
};
struct TextureTarget {
  const char *word;
  GLenum target, query, image; ///< image: the target of level queries; of a cube, its first face
};
[[nodiscard]] const std::array<TextureTarget, 5> &textureTargets();
/// Returns all bound textures with a name, by unit, and each target's texture 0 once, if it has an
/// image.
[[nodiscard]] std::vector<BoundTexture> boundTextures(RasterContext &context);
/// Reads level 0 as a sampler sees its colours; of a cube the first face, of a volume the first
/// slice. Returns an empty picture and `why` if it cannot be read.
[[nodiscard]] Picture readTexture(RasterContext &context, const BoundTexture &texture,
                                  const char *&why);
/// Writes the picture, and smaller ones made from it, to all levels of a 2D texture of the
/// picture's size. Returns false and `why` if that fails.
[[nodiscard]] bool writeTexture(RasterContext &context, const BoundTexture &texture,
                                const Picture &picture, const char *&why);

} // namespace control
} // namespace arbiter::state
