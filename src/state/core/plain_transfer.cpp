#include "state/core/plain_transfer.h"

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

namespace {

constexpr std::array<GLenum, 8> kPack = {
    GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,   GL_PACK_ROW_LENGTH,  GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_ROWS,  GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_PACK_ALIGNMENT};
constexpr std::array<GLenum, 8> kUnpack = {
    GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST,   GL_UNPACK_ROW_LENGTH,  GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_ROWS,  GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ALIGNMENT};
constexpr std::array<GLenum, 10> kTransfer = {
    GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE,
    GL_RED_BIAS,  GL_GREEN_BIAS,  GL_BLUE_BIAS,  GL_ALPHA_BIAS,  GL_DEPTH_BIAS};

GLint get(const host::HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetIntegerv(name, &value);
  return value;
}

} // namespace

PlainTransfer::PlainTransfer(Context &context, Way way)
    : m_context(context), m_errors(*context.host, context.pendingError), m_way(way) {
  const host::HostTable &host = *context.host;
  const auto &names = way == Way::Pack ? kPack : kUnpack;
  for (std::size_t i = 0; way != Way::AsStored && i < names.size(); ++i) {
    m_store[i] = get(host, names[i]);
    host.PixelStorei(names[i], i + 1 == names.size() ? 1 : 0);
  }
  if (context.caps.pixelBuffers && way != Way::AsStored) {
    const bool pack = way == Way::Pack;
    m_buffer = get(host, pack ? GL_PIXEL_PACK_BUFFER_BINDING : GL_PIXEL_UNPACK_BUFFER_BINDING);
    if (m_buffer != 0)
      host.BindBuffer(pack ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER, 0);
  }
  for (std::size_t i = 0; i < kTransfer.size(); ++i) {
    host.GetFloatv(kTransfer[i], &m_transfer[i]);
    host.PixelTransferf(kTransfer[i], i < 5 ? 1.0f : 0.0f);
  }
  m_mapColor = get(host, GL_MAP_COLOR);
  host.PixelTransferi(GL_MAP_COLOR, 0);
  context.dirty |= software::dirty::kPixelStore;
}

PlainTransfer::~PlainTransfer() {
  const host::HostTable &host = *m_context.host;
  const auto &names = m_way == Way::Pack ? kPack : kUnpack;
  for (std::size_t i = 0; m_way != Way::AsStored && i < names.size(); ++i)
    host.PixelStorei(names[i], m_store[i]);
  if (m_buffer != 0)
    host.BindBuffer(m_way == Way::Pack ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER,
                    GLuint(m_buffer));
  for (std::size_t i = 0; i < kTransfer.size(); ++i)
    host.PixelTransferf(kTransfer[i], m_transfer[i]);
  host.PixelTransferi(GL_MAP_COLOR, m_mapColor);
  m_context.dirty |= software::dirty::kPixelStore;
}

} // namespace arbiter::state
