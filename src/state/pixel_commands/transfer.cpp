#include "state/pixel_commands/transfer.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/core/errors.h"
#include "state/core/texture_binding.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// The most pixels of an image that is read: a gigabyte. No framebuffer has more, but a command may
/// ask for any size, as the application needs no memory for it.
constexpr std::size_t kMaxPixels = std::size_t(1) << 26;

/// A temporary texture of the layer's, bound while this lives.
class Scratch {
public:
  Scratch(const RasterContext &context, bool deep)
      : m_host(*context.host), m_target(deep ? GL_TEXTURE_3D : GL_TEXTURE_2D),
        m_name(newName(m_host)), m_bound(m_host, m_target, m_name, sharingOf(context)) {}
  ~Scratch() { m_host.DeleteTextures(1, &m_name); }
  Scratch(const Scratch &) = delete;
  Scratch &operator=(const Scratch &) = delete;

  void give(const ImageInMemory &image, const void *pixels) const {
    if (m_target == GL_TEXTURE_3D)
      m_host.TexImage3D(m_target, 0, GL_RGBA32F, image.width, image.height, image.depth, 0,
                        image.format, image.type, pixels);
    else
      m_host.TexImage2D(m_target, 0, GL_RGBA32F, image.width, image.height, 0, image.format,
                        image.type, pixels);
  }
  void take(GLenum format, GLenum type, void *pixels) const {
    m_host.GetTexImage(m_target, 0, format, type, pixels);
  }

private:
  static GLuint newName(const host::HostTable &host) {
    GLuint name = 0;
    host.GenTextures(1, &name);
    return name;
  }
  const host::HostTable &m_host;
  GLenum m_target;
  GLuint m_name;
  TextureBinding m_bound;
};

/// Runs `function` while the host compiles no list.
template <typename F> void atOnce(RasterContext &context, F function) {
  if (context.listMode != 0)
    context.list->outside(context, function);
  else
    function();
}

/// Runs `function` with the application's pixel store and plain transfer. Returns false after
/// raising its error.
template <typename F> bool succeeds(RasterContext &context, const char *command, F function) {
  GLenum error = GL_NO_ERROR;
  {
    const PlainArithmetic arithmetic(context);
    function();
    error = takeHostErrors(*context.host);
  }
  if (error != GL_NO_ERROR)
    raise(context, error, command);
  return error == GL_NO_ERROR;
}

std::optional<imaging::Pixels> unpack(RasterContext &context, const ImageInMemory &image,
                                      const void *pixels) {
  imaging::Pixels result{image.width, image.height, image.depth, {}};
  const Scratch scratch(context, image.dimensions == 3);
  const bool given = succeeds(context, "an image's format, type or size",
                              [&] { scratch.give(image, result.count() != 0 ? pixels : nullptr); });
  if (!given)
    return {};
  result.texels.resize(result.count());
  const PlainTransfer plain(context, PixelStore::Pack);
  if (result.count() != 0)
    scratch.take(GL_RGBA, GL_FLOAT, result.texels.data());
  return result;
}

bool pack(RasterContext &context, const imaging::Pixels &pixels, GLenum format, GLenum type,
          void *to) {
  const Scratch scratch(context, false);
  {
    const PlainTransfer plain(context, PixelStore::Unpack);
    scratch.give({.width = pixels.width, .height = pixels.height}, pixels.texels.data());
  }
  return succeeds(context, "an image's format or type", [&] { scratch.take(format, type, to); });
}

/// Reads the framebuffer. Returns the host's error.
GLenum read(RasterContext &context, GLint x, GLint y, imaging::Pixels &to) {
  if (context.software)
    context.software->residency.synchronise("pixels that are read for imaging");
  const PlainTransfer plain(context, PixelStore::Pack);
  context.host->ReadPixels(x, y, to.width, to.height, GL_RGBA, GL_FLOAT, to.texels.data());
  return takeHostErrors(*context.host);
}

} // namespace

bool isColorFormat(GLenum format) {
  switch (format) {
  case GL_COLOR_INDEX:
  case GL_RED:
  case GL_GREEN:
  case GL_BLUE:
  case GL_ALPHA:
  case GL_RG:
  case GL_RGB:
  case GL_RGBA:
  case GL_BGR:
  case GL_BGRA:
  case GL_ABGR_EXT:
  case GL_LUMINANCE:
  case GL_LUMINANCE_ALPHA:
    return true;
  default:
    return false;
  }
}

std::optional<imaging::Pixels> unpackPixels(RasterContext &context, const ImageInMemory &image,
                                            const void *pixels) {
  std::optional<imaging::Pixels> result;
  if (image.width < 0 || image.height < 0 || image.depth < 0)
    raise(context, GL_INVALID_VALUE, "an image's size is negative");
  else
    atOnce(context, [&] { result = unpack(context, image, pixels); });
  return result;
}

bool arePixels(RasterContext &context, GLenum format, GLenum type) {
  return unpackPixels(context, {.dimensions = 1, .width = 0, .format = format, .type = type},
                      nullptr)
      .has_value();
}

bool packPixels(RasterContext &context, const imaging::Pixels &pixels, GLenum format, GLenum type,
                void *to) {
  if (pixels.count() == 0)
    return arePixels(context, format, type);
  bool packed = true;
  atOnce(context, [&] { packed = pack(context, pixels, format, type, to); });
  return packed;
}

std::optional<imaging::Pixels> readFramebuffer(RasterContext &context, GLint x, GLint y,
                                               GLsizei width, GLsizei height) {
  if (width < 0 || height < 0) {
    raise(context, GL_INVALID_VALUE, "a size is negative");
    return {};
  }
  imaging::Pixels result{width, height, 1, {}};
  if (result.count() > kMaxPixels) {
    raise(context, GL_OUT_OF_MEMORY, "an image that is read for imaging");
    return {};
  }
  result.texels.resize(result.count());
  GLenum error = GL_NO_ERROR;
  if (result.count() != 0)
    atOnce(context, [&] { error = read(context, x, y, result); });
  if (error == GL_NO_ERROR)
    return result;
  raise(context, error, "the read framebuffer has no colours");
  return {};
}

imaging::FirstArithmetic firstArithmetic(const RasterContext &context) {
  const host::HostTable &host = *context.host;
  constexpr GLenum kScales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
  constexpr GLenum kBiases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
  imaging::FirstArithmetic first;
  for (std::size_t c = 0; c < 4; ++c) {
    host.GetFloatv(kScales[c], &first.scaleBias.scale[c]);
    host.GetFloatv(kBiases[c], &first.scaleBias.bias[c]);
  }
  first.maps = hostInteger(host, GL_MAP_COLOR) != 0;
  if (!first.maps)
    return first;
  for (GLenum c = 0; c < 4; ++c)
    first.map[c].resize(std::size_t(std::max(hostInteger(host, GL_PIXEL_MAP_R_TO_R_SIZE + c), 0)));
  // They would be written to the pixel buffer, if one were bound.
  const GLint buffer =
      context.caps.pixelBuffers ? hostInteger(host, GL_PIXEL_PACK_BUFFER_BINDING) : 0;
  if (buffer != 0)
    host.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  for (GLenum c = 0; c < 4; ++c)
    host.GetPixelMapfv(GL_PIXEL_MAP_R_TO_R + c, first.map[c].data());
  if (buffer != 0)
    host.BindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(buffer));
  return first;
}

} // namespace arbiter::state
