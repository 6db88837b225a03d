#pragma once
#include <iterator>

#include "host/host_table.h"
#include "state/core/texture_binding.h"
#include "state/mirror/dirty_bits.h"
#include "state/residency/residency_images.h"
#include "util/log.h"

/// Scopes that change host state for moving pixels, and restore it. For the files of residency*.cpp
/// only.
namespace arbiter::state {

/// Binds a texture of the application's or the layer's for the lifetime of the result.
[[nodiscard]] TextureBinding bindTexture(const ResidentImages &images, GLenum target, GLuint name);

/// Sets plain pixel store and transfer in one direction: rows of `rowLength` pixels, no buffer.
class PlainPixels {
public:
  enum class Way : std::uint8_t { Pack, Unpack };
  /// \param topRowFirst for reads only; needs PACK_INVERT_MESA
  PlainPixels(ResidentImages &images, Way way, GLint rowLength, GLint imageHeight,
              bool topRowFirst = false);
  ~PlainPixels();
  PlainPixels(const PlainPixels &) = delete;
  PlainPixels &operator=(const PlainPixels &) = delete;

private:
  const host::HostTable &m_host;
  PixelModes::Store m_was, m_is;
  Way m_way;
  bool m_transfers = false;
  GLfloat m_scale[5] = {}, m_bias[5] = {};
  GLint m_mapColor = 0, m_index[3] = {};
  GLint m_clamp = 0;
  bool m_clamped = false;
};

/// Binds framebuffers of the layer's, or the window's, and disables the scissor test.
class FramebufferBinding {
public:
  FramebufferBinding(ResidentImages &images, GLuint draw, GLuint read);
  ~FramebufferBinding();
  FramebufferBinding(const FramebufferBinding &) = delete;
  FramebufferBinding &operator=(const FramebufferBinding &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_draw = 0, m_read = 0;
  GLboolean m_scissor = GL_FALSE;
};

/// Names that applications do not use. Gen could return a name that an application makes up itself,
/// which is allowed before 3.1. Hosts generate names above the highest one in use while there are
/// any, and search small ones after that; so these are the last ones.
inline constexpr GLuint kOurTexture = 0xFFFFFFFEu;
inline constexpr GLuint kOurReadFramebuffer = 0xFFFFFFFEu;
inline constexpr GLuint kOurDrawFramebuffer = 0xFFFFFFFDu;

} // namespace arbiter::state
