#include "state/client_pixels/plain_transfer.h"

#include <GL/glext.h>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/core_context.h"
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

const std::array<GLenum, 8> &namesOf(PixelStore way) {
  return way == PixelStore::Pack ? kPack : kUnpack;
}
GLenum bufferOf(PixelStore way) {
  return way == PixelStore::Pack ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER;
}

} // namespace

PlainArithmetic::PlainArithmetic(CoreContext &context)
    : m_context(context), m_errors(*context.host, context.errors.pending) {
  const host::HostTable &host = *context.host;
  for (std::size_t i = 0; i < kTransfer.size(); ++i) {
    host.GetFloatv(kTransfer[i], &m_transfer[i]);
    host.PixelTransferf(kTransfer[i], i < 5 ? 1.0f : 0.0f);
  }
  m_mapColor = hostInteger(host, GL_MAP_COLOR);
  host.PixelTransferi(GL_MAP_COLOR, 0);
  context.dirty |= dirty::kPixelStore;
}

PlainArithmetic::~PlainArithmetic() {
  const host::HostTable &host = *m_context.host;
  for (std::size_t i = 0; i < kTransfer.size(); ++i)
    host.PixelTransferf(kTransfer[i], m_transfer[i]);
  host.PixelTransferi(GL_MAP_COLOR, m_mapColor);
  m_context.dirty |= dirty::kPixelStore;
}

PlainTransfer::PlainTransfer(CoreContext &context, PixelStore way)
    : m_context(context), m_arithmetic(context), m_way(way) {
  const host::HostTable &host = *context.host;
  const std::array<GLenum, 8> &names = namesOf(way);
  for (std::size_t i = 0; i < names.size(); ++i) {
    m_store[i] = hostInteger(host, names[i]);
    host.PixelStorei(names[i], i + 1 == names.size() ? 1 : 0);
  }
  if (!context.caps.pixelBuffers)
    return;
  m_buffer = hostInteger(host, way == PixelStore::Pack ? GL_PIXEL_PACK_BUFFER_BINDING
                                                       : GL_PIXEL_UNPACK_BUFFER_BINDING);
  if (m_buffer != 0)
    host.BindBuffer(bufferOf(way), 0);
}

PlainTransfer::~PlainTransfer() {
  const host::HostTable &host = *m_context.host;
  const std::array<GLenum, 8> &names = namesOf(m_way);
  for (std::size_t i = 0; i < names.size(); ++i)
    host.PixelStorei(names[i], m_store[i]);
  if (m_buffer != 0)
    host.BindBuffer(bufferOf(m_way), GLuint(m_buffer));
}

} // namespace arbiter::state
