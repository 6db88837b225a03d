#include "state/residency/residency_host.h"

#include "state/capabilities/host_integer.h"

namespace arbiter::state {

namespace {

struct TransferNames {
  GLenum scale, bias;
};
constexpr TransferNames kTransfers[] = {{GL_RED_SCALE, GL_RED_BIAS},
                                        {GL_GREEN_SCALE, GL_GREEN_BIAS},
                                        {GL_BLUE_SCALE, GL_BLUE_BIAS},
                                        {GL_ALPHA_SCALE, GL_ALPHA_BIAS},
                                        {GL_DEPTH_SCALE, GL_DEPTH_BIAS}};

PixelModes::Store storeOf(ResidentImages &images, bool pack) {
  const host::HostTable &host = *images.hot.host;
  PixelModes::Store store;
  store.swapBytes = hostInteger(host, pack ? GL_PACK_SWAP_BYTES : GL_UNPACK_SWAP_BYTES);
  store.lsbFirst = hostInteger(host, pack ? GL_PACK_LSB_FIRST : GL_UNPACK_LSB_FIRST);
  store.rowLength = hostInteger(host, pack ? GL_PACK_ROW_LENGTH : GL_UNPACK_ROW_LENGTH);
  store.imageHeight = hostInteger(host, pack ? GL_PACK_IMAGE_HEIGHT : GL_UNPACK_IMAGE_HEIGHT);
  store.skipRows = hostInteger(host, pack ? GL_PACK_SKIP_ROWS : GL_UNPACK_SKIP_ROWS);
  store.skipPixels = hostInteger(host, pack ? GL_PACK_SKIP_PIXELS : GL_UNPACK_SKIP_PIXELS);
  store.skipImages = hostInteger(host, pack ? GL_PACK_SKIP_IMAGES : GL_UNPACK_SKIP_IMAGES);
  store.alignment = hostInteger(host, pack ? GL_PACK_ALIGNMENT : GL_UNPACK_ALIGNMENT);
  if (images.caps.has("GL_ARB_pixel_buffer_object"))
    store.buffer =
        hostInteger(host, pack ? GL_PIXEL_PACK_BUFFER_BINDING : GL_PIXEL_UNPACK_BUFFER_BINDING);
  if (pack && images.caps.has("GL_MESA_pack_invert"))
    store.invert = hostInteger(host, GL_PACK_INVERT_MESA);
  return store;
}

} // namespace

const PixelModes &pixelModes(ResidentImages &images) {
  if ((images.hot.dirty & dirty::kPixelStore) == 0) [[likely]]
    return images.modes;
  images.hot.dirty &= ~dirty::kPixelStore;
  HostErrorScope errors = errorScope(images);
  PixelModes &modes = images.modes;
  modes.pack = storeOf(images, true);
  modes.unpack = storeOf(images, false);
  modes.transfers = hostInteger(*images.hot.host, GL_MAP_COLOR) != 0;
  modes.transfersDepth = false;
  for (const TransferNames &names : kTransfers) {
    GLfloat scale = 1, bias = 0;
    images.hot.host->GetFloatv(names.scale, &scale);
    images.hot.host->GetFloatv(names.bias, &bias);
    if (scale != 1.0f || bias != 0.0f)
      (names.scale == GL_DEPTH_SCALE ? modes.transfersDepth : modes.transfers) = true;
  }
  modes.transfersDepth = modes.transfersDepth ||
                         hostInteger(*images.hot.host, GL_INDEX_SHIFT) != 0 ||
                         hostInteger(*images.hot.host, GL_INDEX_OFFSET) != 0 ||
                         hostInteger(*images.hot.host, GL_MAP_STENCIL) != 0;
  return modes;
}

TextureBinding bindTexture(const ResidentImages &images, GLenum target, GLuint name) {
  const bool others =
      images.groupContexts.load(std::memory_order_relaxed) > 1 || !images.deletedNames.none();
  return {*images.hot.host, target, name, {others, others && !isNamedAsBound(images, name)}};
}

// --- PlainPixels ---

namespace {

struct StoreNames {
  GLenum swapBytes, lsbFirst, rowLength, imageHeight, skipRows, skipPixels, skipImages, alignment,
      buffer;
};
constexpr StoreNames kPack = {GL_PACK_SWAP_BYTES,   GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH,
                              GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                              GL_PACK_SKIP_IMAGES,  GL_PACK_ALIGNMENT, GL_PIXEL_PACK_BUFFER};
constexpr StoreNames kUnpack = {
    GL_UNPACK_SWAP_BYTES,   GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_IMAGES,  GL_UNPACK_ALIGNMENT, GL_PIXEL_UNPACK_BUFFER};

void change(const host::HostTable &host, bool pack, const PixelModes::Store &from,
            const PixelModes::Store &to) {
  const StoreNames &n = pack ? kPack : kUnpack;
  const auto set = [&](GLenum pname, GLint was, GLint is) {
    if (was != is)
      host.PixelStorei(pname, is);
  };
  set(n.swapBytes, from.swapBytes, to.swapBytes);
  set(n.lsbFirst, from.lsbFirst, to.lsbFirst);
  set(n.rowLength, from.rowLength, to.rowLength);
  set(n.imageHeight, from.imageHeight, to.imageHeight);
  set(n.skipRows, from.skipRows, to.skipRows);
  set(n.skipPixels, from.skipPixels, to.skipPixels);
  set(n.skipImages, from.skipImages, to.skipImages);
  set(n.alignment, from.alignment, to.alignment);
  if (pack)
    set(GL_PACK_INVERT_MESA, from.invert, to.invert);
  if (from.buffer != to.buffer)
    host.BindBuffer(n.buffer, GLuint(to.buffer));
}

} // namespace

PlainPixels::PlainPixels(ResidentImages &images, Way way, GLint rowLength, GLint imageHeight,
                         bool topRowFirst)
    : m_host(*images.hot.host), m_way(way) {
  const PixelModes &modes = pixelModes(images);
  m_was = way == Way::Pack ? modes.pack : modes.unpack;
  m_is = {};
  m_is.alignment = 1;
  m_is.rowLength = rowLength;
  m_is.imageHeight = imageHeight;
  m_is.invert = topRowFirst ? 1 : 0;
  change(m_host, way == Way::Pack, m_was, m_is);
  m_transfers = modes.transfers || modes.transfersDepth;
  if (m_transfers) {
    m_mapColor = hostInteger(m_host, GL_MAP_COLOR);
    m_host.PixelTransferi(GL_MAP_COLOR, 0);
    m_index[0] = hostInteger(m_host, GL_MAP_STENCIL);
    m_index[1] = hostInteger(m_host, GL_INDEX_SHIFT);
    m_index[2] = hostInteger(m_host, GL_INDEX_OFFSET);
    m_host.PixelTransferi(GL_MAP_STENCIL, 0);
    m_host.PixelTransferi(GL_INDEX_SHIFT, 0);
    m_host.PixelTransferi(GL_INDEX_OFFSET, 0);
    for (std::size_t i = 0; i < std::size(kTransfers); ++i) {
      m_host.GetFloatv(kTransfers[i].scale, &m_scale[i]);
      m_host.GetFloatv(kTransfers[i].bias, &m_bias[i]);
      m_host.PixelTransferf(kTransfers[i].scale, 1.0f);
      m_host.PixelTransferf(kTransfers[i].bias, 0.0f);
    }
  }
  if (way == Way::Pack &&
      (images.caps.major >= 3 || images.caps.has("GL_ARB_color_buffer_float"))) {
    // GL_FIXED_ONLY, the default, does not clamp floats. It is left in place: after any other value
    // a host restores all of GL_COLOR_BUFFER_BIT in PopAttrib, including the draw buffers, to
    // whatever framebuffer is bound then.
    m_clamp = hostInteger(m_host, GL_CLAMP_READ_COLOR);
    m_clamped = m_clamp == GL_TRUE;
    if (m_clamped)
      m_host.ClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  }
}

PlainPixels::~PlainPixels() {
  if (m_clamped)
    m_host.ClampColor(GL_CLAMP_READ_COLOR, GLenum(m_clamp));
  if (m_transfers) {
    m_host.PixelTransferi(GL_MAP_COLOR, m_mapColor);
    m_host.PixelTransferi(GL_MAP_STENCIL, m_index[0]);
    m_host.PixelTransferi(GL_INDEX_SHIFT, m_index[1]);
    m_host.PixelTransferi(GL_INDEX_OFFSET, m_index[2]);
    for (std::size_t i = 0; i < std::size(kTransfers); ++i) {
      m_host.PixelTransferf(kTransfers[i].scale, m_scale[i]);
      m_host.PixelTransferf(kTransfers[i].bias, m_bias[i]);
    }
  }
  change(m_host, m_way == Way::Pack, m_is, m_was);
}

// --- FramebufferBinding ---

FramebufferBinding::FramebufferBinding(ResidentImages &images, GLuint draw, GLuint read)
    : m_host(*images.hot.host) {
  m_draw = hostInteger(m_host, GL_DRAW_FRAMEBUFFER_BINDING);
  m_read = hostInteger(m_host, GL_READ_FRAMEBUFFER_BINDING);
  m_scissor = m_host.IsEnabled(GL_SCISSOR_TEST);
  // The EXT entry point accepts a name that Gen did not return.
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, draw);
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, read);
  if (m_scissor)
    m_host.Disable(GL_SCISSOR_TEST);
}

FramebufferBinding::~FramebufferBinding() {
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(m_draw));
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, GLuint(m_read));
  if (m_scissor)
    m_host.Enable(GL_SCISSOR_TEST);
}

} // namespace arbiter::state
