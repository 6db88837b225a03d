#pragma once
#include <iterator>

#include "host/host_table.h"
#include "state/core/texture_binding.h"
#include "state/mirror/dirty_bits.h"
#include "state/residency/residency_images.h"
#include "util/log.h"

/// Host state that moving pixels needs otherwise than the application left it, put back at the end.
/// For the files of residency*.cpp only.
namespace arbiter::state::software {

/// A texture of the application's or of the layer's, bound while the answer lives.
[[nodiscard]] TextureBinding bindTexture(const ResidentImages &images, GLenum target, GLuint name);

/// Plain pixel store and transfer in one direction: rows of `rowLength` pixels, no buffer.
class PlainPixels {
public:
  enum class Way : std::uint8_t { Pack, Unpack };
  /// \param topRowFirst reads only, where PACK_INVERT_MESA is there
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

/// Framebuffers of the layer's bound, or the window's, with its own buffers chosen.
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

/// Names that no application makes. One that Gen gives might be one that an application takes which
/// makes up its own names (allowed before 3.1). The host goes on from the highest name that is in
/// use while there are any left, and else looks for small ones: hence the very last.
inline constexpr GLuint kOurTexture = 0xFFFFFFFEu;
inline constexpr GLuint kOurReadFramebuffer = 0xFFFFFFFEu;
inline constexpr GLuint kOurDrawFramebuffer = 0xFFFFFFFDu;

} // namespace arbiter::state::software
