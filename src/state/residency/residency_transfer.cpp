// Transfers pixels between the host and the shadows.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"
#include "util/thread.h"

namespace arbiter::state {

namespace {

using swrast::Image;

bool isDepth(const PixelImage &image) {
  return image.base == GL_DEPTH_COMPONENT || image.base == GL_DEPTH_STENCIL;
}

/// Rows in memory from the lowest address, and their distance in pixels.
struct Rows {
  std::uint8_t *data = nullptr;
  GLint rowLength = 0;
  bool topRowFirst = false;
};
Rows rowsOf(const Image &image) {
  Rows rows;
  rows.topRowFirst = image.rowStride < 0 && image.height > 1;
  rows.data = image.pixel(0, rows.topRowFirst ? image.height - 1 : 0);
  const std::int64_t stride = image.rowStride < 0 ? -image.rowStride : image.rowStride;
  rows.rowLength = GLint(stride / abi::bytesOf(image.format.layout));
  return rows;
}
GLint imageHeightOf(const Image &image) {
  return image.depth > 1 ? GLint(image.sliceStride / image.rowStride) : 0;
}

std::uint64_t bytesOf(const PixelImage &image) {
  return std::uint64_t(image.width) * std::uint64_t(image.height) * std::uint64_t(image.depth) *
         std::uint64_t(abi::bytesOf(image.format.layout));
}

/// Selects what the host reads from or draws to: the image as the only attachment of a framebuffer
/// of the layer's, or the window's buffer.
class Attachment {
public:
  Attachment(ResidentImages &images, GLenum framebuffer, const PixelImage &image)
      : m_host(*images.hot.host), m_framebuffer(framebuffer) {
    if (image.place.kind == Place::Kind::Window) {
      if (isDepth(image))
        return;
      m_host.GetIntegerv(framebuffer == GL_READ_FRAMEBUFFER ? GL_READ_BUFFER : GL_DRAW_BUFFER,
                         &m_buffer);
      // Set it only if it differs: the host keeps the last set buffer beside the effective one, and
      // PopAttrib would find them to differ.
      m_window = m_buffer != GLint(image.place.target);
      if (m_window)
        set(GLint(image.place.target));
      return;
    }
    m_attachment = !isDepth(image)                  ? GL_COLOR_ATTACHMENT0
                   : image.base == GL_DEPTH_STENCIL ? GL_DEPTH_STENCIL_ATTACHMENT
                                                    : GL_DEPTH_ATTACHMENT;
    if (image.place.kind == Place::Kind::Renderbuffer)
      m_host.FramebufferRenderbuffer(framebuffer, m_attachment, GL_RENDERBUFFER, image.place.name);
    else
      m_host.FramebufferTexture2D(framebuffer, m_attachment, image.place.target, image.place.name,
                                  image.place.level);
    // The buffers keep a new framebuffer's default, the first colour attachment. A host that was
    // given others would restore them in PopAttrib, for another framebuffer.
  }
  ~Attachment() {
    if (m_window)
      set(m_buffer);
    else if (m_attachment != 0)
      m_host.FramebufferRenderbuffer(m_framebuffer, m_attachment, GL_RENDERBUFFER, 0);
  }
  Attachment(const Attachment &) = delete;
  Attachment &operator=(const Attachment &) = delete;

private:
  void set(GLint buffer) {
    if (m_framebuffer == GL_READ_FRAMEBUFFER)
      m_host.ReadBuffer(GLenum(buffer));
    else
      m_host.DrawBuffer(GLenum(buffer));
  }
  const host::HostTable &m_host;
  GLenum m_framebuffer;
  GLenum m_attachment = 0;
  GLint m_buffer = 0;
  bool m_window = false;
};

/// Turns FRAMEBUFFER_SRGB off, so that writes to sRGB buffers are not encoded.
class EncodingOff {
public:
  explicit EncodingOff(const ResidentImages &images)
      : m_host(*images.hot.host),
        m_on(images.caps.srgbFramebuffer && m_host.IsEnabled(GL_FRAMEBUFFER_SRGB)) {
    if (m_on)
      m_host.Disable(GL_FRAMEBUFFER_SRGB);
  }
  ~EncodingOff() {
    if (m_on)
      m_host.Enable(GL_FRAMEBUFFER_SRGB);
  }
  EncodingOff(const EncodingOff &) = delete;
  EncodingOff &operator=(const EncodingOff &) = delete;

private:
  const host::HostTable &m_host;
  bool m_on;
};

/// Turns GENERATE_MIPMAP off, so that the bound texture's other levels stay unchanged.
class MipmapsKept {
public:
  MipmapsKept(const ResidentImages &images, GLenum imageTarget)
      : m_host(*images.hot.host), m_target(textureTargetOf(imageTarget)),
        m_made(makesMipmaps(images, imageTarget)) {
    if (m_made)
      m_host.TexParameteri(m_target, GL_GENERATE_MIPMAP, GL_FALSE);
  }
  ~MipmapsKept() {
    if (m_made)
      m_host.TexParameteri(m_target, GL_GENERATE_MIPMAP, GL_TRUE);
  }
  MipmapsKept(const MipmapsKept &) = delete;
  MipmapsKept &operator=(const MipmapsKept &) = delete;

private:
  const host::HostTable &m_host;
  GLenum m_target;
  bool m_made;
};

/// True if the bound texture's level still has the size that the image was described with.
/// Transfers rely on it. The name may have been deleted, and binding a free name makes a new
/// texture.
bool isAsDescribed(const host::HostTable &host, const PixelImage &image) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetTexLevelParameteriv(image.place.target, image.place.level, pname, &value);
    return value;
  };
  return get(GL_TEXTURE_WIDTH) == image.width && get(GL_TEXTURE_HEIGHT) == image.height &&
         get(GL_TEXTURE_DEPTH) == image.depth &&
         get(GL_TEXTURE_INTERNAL_FORMAT) == image.internalFormat;
}

/// Reads a texture. Returns false if it is not as described.
bool readTexture(ResidentImages &images, const PixelImage &image, const Image &to,
                 const GlFormat &gl) {
  const host::HostTable &host = *images.hot.host;
  if (!textureExists(images, image.place.name))
    return false;
  const Rows rows = rowsOf(to);
  const TextureBinding binding =
      bindTexture(images, textureTargetOf(image.place.target), image.place.name);
  if (!isAsDescribed(host, image))
    return false;
  const PlainPixels pixels(images, PlainPixels::Way::Pack, rows.rowLength, imageHeightOf(to));
  // A neighbour without synchronisation may even now give it another size. The robust Get writes no
  // more than the given size.
  const std::ptrdiff_t room = to.storage->data() + to.storage->bytes() - rows.data;
  const auto bufferSize = GLsizei(std::min(room, std::ptrdiff_t(INT32_MAX)));
  if (images.caps.has("GL_ARB_robustness"))
    host.GetnTexImageARB(image.place.target, image.place.level, gl.format, gl.type, bufferSize,
                         rows.data);
  else
    host.GetTexImage(image.place.target, image.place.level, gl.format, gl.type, rows.data);
  return true;
}

void readBuffer(ResidentImages &images, const PixelImage &image, const Image &to,
                const GlFormat &gl) {
  const Rows rows = rowsOf(to);
  const bool isWindow = image.place.kind == Place::Kind::Window;
  GLint draw = 0;
  images.hot.host->GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
  const FramebufferBinding framebuffers(images, GLuint(draw), isWindow ? 0 : kOurReadFramebuffer);
  const Attachment attachment(images, GL_READ_FRAMEBUFFER, image);
  const PlainPixels pixels(images, PlainPixels::Way::Pack, rows.rowLength, 0, rows.topRowFirst);
  images.hot.host->ReadPixels(0, 0, image.width, image.height, gl.format, gl.type, rows.data);
}

/// Sets the lower 8 bits of 24-bit depths, which upload as 32 bits (glFormatOf()). Hosts take the
/// upper 24 bits (Mesa 22.3.6), or scale by (2^24-1)/(2^32-1) and cut off (25.0.7). Both give the
/// same if the lower 8 bits are one more than the upper ones. Without stencil these bits are
/// unused.
void fillLowerBits(Image &image) {
  if (!swrast::makeWritable(image, true))
    throw std::bad_alloc();
  for (int z = 0; z < image.depth; ++z)
    for (int y = 0; y < image.height; ++y) {
      std::uint8_t *const row = image.pixel(0, y, z);
      for (std::ptrdiff_t x = 0; x < image.width; ++x) {
        std::uint32_t word;
        std::memcpy(&word, row + 4 * x, sizeof word);
        word = (word & ~0xFFu) | std::min((word >> 24) + 1, 0xFFu);
        std::memcpy(row + 4 * x, &word, sizeof word);
      }
    }
}

/// Returns an image that the host can read: the shadow itself, or a copy in another order.
Image plain(const PixelImage &image, bool topRowFirst, GlFormat &gl) {
  const Image &shadow = image.shadow;
  const bool flipped = shadow.rowStride < 0 && shadow.height > 1;
  if (glFormatOf(shadow.format, image.base, gl) && flipped == topRowFirst)
    return shadow;
  abi::Format format = shadow.format;
  if (!glFormatOf(format, image.base, gl)) {
    format = image.format;
    (void)glFormatOf(format, image.base, gl);
  }
  Image copy = swrast::makeImage(format, shadow.width, shadow.height, shadow.depth, topRowFirst);
  if (copy.empty())
    return copy;
  for (int z = 0; z < shadow.depth; ++z)
    swrast::copyPixels(copy, 0, 0, z, shadow, {0, 0, shadow.width, shadow.height}, z);
  return copy;
}

void writeTexture(ResidentImages &images, GLenum target, GLint level, const Image &from,
                  const GlFormat &gl) {
  const host::HostTable &host = *images.hot.host;
  const Rows rows = rowsOf(from);
  const PlainPixels pixels(images, PlainPixels::Way::Unpack, rows.rowLength, imageHeightOf(from));
  if (target == GL_TEXTURE_1D)
    host.TexSubImage1D(target, level, 0, from.width, gl.format, gl.type, rows.data);
  else if (target == GL_TEXTURE_3D)
    host.TexSubImage3D(target, level, 0, 0, 0, from.width, from.height, from.depth, gl.format,
                       gl.type, rows.data);
  else
    host.TexSubImage2D(target, level, 0, 0, from.width, from.height, gl.format, gl.type, rows.data);
}

/// Returns the internal format of a texture that copies to the image without conversion. For a
/// window it is unsized, so that the host keeps the order of the components.
GLint uploadFormat(const PixelImage &image, const GlFormat &gl) {
  // A blit would decode sRGB.
  if (image.srgb)
    return GL_RGBA8;
  if (!isDepth(image) && image.place.kind != Place::Kind::Window)
    return image.internalFormat;
  if (!isDepth(image))
    switch (gl.type) {
    case GL_HALF_FLOAT:
      return GL_RGBA16F;
    case GL_FLOAT:
      return GL_RGBA32F;
    case GL_UNSIGNED_SHORT:
      return GL_RGBA16;
    case GL_UNSIGNED_SHORT_5_6_5:
      return GL_RGB565;
    case GL_UNSIGNED_SHORT_4_4_4_4:
      return GL_RGBA4;
    case GL_UNSIGNED_SHORT_5_5_5_1:
      return GL_RGB5_A1;
    case GL_UNSIGNED_INT_2_10_10_10_REV:
      return GL_RGB10_A2;
    default:
      return GL_RGBA;
    }
  if (gl.format == GL_DEPTH_STENCIL)
    return GL_DEPTH24_STENCIL8;
  if (image.format.layout == abi::Layout::Depth32)
    return GL_DEPTH_COMPONENT32;
  return gl.type == GL_FLOAT            ? GL_DEPTH_COMPONENT32F
         : gl.type == GL_UNSIGNED_SHORT ? GL_DEPTH_COMPONENT16
                                        : GL_DEPTH_COMPONENT24;
}

/// Writes to a renderbuffer or a buffer of the window. The host can only draw or blit to them, and
/// a blit between equal formats is a copy. The texture has the rows in memory order; if the top row
/// is first, the blit flips them.
void writeBuffer(ResidentImages &images, PixelImage &image) {
  const host::HostTable &host = *images.hot.host;
  const bool isWindow = image.place.kind == Place::Kind::Window;
  const bool flipped = image.shadow.rowStride < 0 && image.shadow.height > 1;
  GlFormat gl;
  const Image from = plain(image, flipped, gl);
  if (from.empty())
    throw std::bad_alloc(); // the shadow stays the valid copy
  const GLint internalFormat = uploadFormat(image, gl);
  const TextureBinding binding = bindTexture(images, GL_TEXTURE_2D, kOurTexture);
  ObjectImages &objects = images.objects;
  const ObjectImages::Way way = {image.width, image.height, internalFormat};
  if (objects.way != way) {
    const PlainPixels pixels(images, PlainPixels::Way::Unpack, 0, 0);
    host.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    host.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    host.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    // The order of components is a hint how the host should store them.
    host.TexImage2D(GL_TEXTURE_2D, 0, internalFormat, image.width, image.height, 0, gl.format,
                    gl.format == GL_BGRA ? GL_UNSIGNED_INT_8_8_8_8_REV : gl.type, nullptr);
    objects.way = way;
  }
  writeTexture(images, GL_TEXTURE_2D, 0, from, gl);

  const FramebufferBinding framebuffers(images, isWindow ? 0 : kOurDrawFramebuffer,
                                        kOurReadFramebuffer);
  PixelImage source;
  source.place = {Place::Kind::Texture, kOurTexture, GL_TEXTURE_2D, 0};
  source.base = image.base;
  const Attachment read(images, GL_READ_FRAMEBUFFER, source);
  const Attachment draw(images, GL_DRAW_FRAMEBUFFER, image);
  const GLbitfield mask = !isDepth(image) ? GL_COLOR_BUFFER_BIT
                          : gl.format == GL_DEPTH_STENCIL
                              ? GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT
                              : GL_DEPTH_BUFFER_BIT;
  const EncodingOff plainBlit(images);
  host.BlitFramebuffer(0, flipped ? image.height : 0, image.width, flipped ? 0 : image.height, 0, 0,
                       image.width, image.height, mask, GL_NEAREST);
}

} // namespace

bool download(ResidentImages &images, PixelImage &image) {
  const NoCancel scope;
  GlFormat gl;
  if (!glFormatOf(image.format, image.base, gl))
    return false;
  HostErrorScope errors = errorScope(images);
  const bool topRowFirst =
      image.place.kind == Place::Kind::Window && images.caps.has("GL_MESA_pack_invert");
  Image to = makeShadow(image, image.format, topRowFirst);
  if (to.empty())
    return false;
  bool read = true;
  if (image.place.kind == Place::Kind::Texture)
    read = readTexture(images, image, to, gl);
  else
    readBuffer(images, image, to, gl);
  if (!read || errors.failed())
    return false;
  image.shadow = std::move(to);
  images.objects.changed();
  setValid(images, image, Valid::Both);
  ResidencyStatistics &statistics = images.objects.statistics;
  ++statistics.downloads;
  statistics.downloadedBytes += bytesOf(image);
  return true;
}

void upload(ResidentImages &images, PixelImage &image) {
  const NoCancel scope;
  HostErrorScope errors = errorScope(images);
  if (image.base == GL_DEPTH_COMPONENT && !image.shadow.empty() &&
      image.shadow.format.layout == abi::Layout::Depth24Stencil8)
    fillLowerBits(image.shadow);
  if (image.place.kind == Place::Kind::Texture) {
    // A texture that a neighbour deleted or resized is left to the neighbour.
    if (!textureExists(images, image.place.name))
      return;
    GlFormat gl;
    const Image from = plain(image, false, gl);
    if (from.empty())
      throw std::bad_alloc();
    const TextureBinding binding =
        bindTexture(images, textureTargetOf(image.place.target), image.place.name);
    if (!isAsDescribed(*images.hot.host, image))
      return;
    const MipmapsKept kept(images, image.place.target);
    writeTexture(images, image.place.target, image.place.level, from, gl);
  } else {
    writeBuffer(images, image);
  }
  if (errors.failed()) {
    images.objects.way = {};
    logWarn("residency", "the host took no pixels of an image of %d x %d", image.width,
            image.height);
  }
  ResidencyStatistics &statistics = images.objects.statistics;
  ++statistics.uploads;
  statistics.uploadedBytes += bytesOf(image);
}

} // namespace arbiter::state
