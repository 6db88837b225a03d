#pragma once
#include "common/image.h"
#include <cstdint>
#include <epoxy/gl.h>
#include <vector>

namespace demos {

enum class Filter { Nearest, Linear };
enum class Wrap { Clamp, Repeat };

/// A texture object of the current context. The destructor deletes it.
class Texture {
public:
  Texture() = default;
  ~Texture();
  Texture(const Texture &) = delete;
  Texture &operator=(const Texture &) = delete;

  void create2d(const Image &image, Filter filter, Wrap wrap);
  /// Creates a texture of 16-bit red and green, 2 values for each texel; blue is 0 and alpha 1.
  void create2dPairs16(int width, int height, const std::vector<std::uint16_t> &redGreen);
  void create1d(const Image &row, Filter filter);
  /// Binds the texture to unit \p unit and leaves that unit active.
  void bind(GLuint unit) const;
  /// Copies the read buffer's lower left width x height pixels into level 0 (texture feedback).
  void copyFromFramebuffer(GLuint unit, int width, int height) const;

private:
  void begin(GLenum target, Filter filter, Wrap wrap);
  GLuint m_name = 0;
  GLenum m_target = GL_TEXTURE_2D;
};

} // namespace demos
