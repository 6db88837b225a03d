#include "state/programs/texture_shaders/component_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "host/host_table.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/core/errors.h"
#include "state/core/texture_binding.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::texture_shader::Base;
using fp::texture_shader::Signs;

static_assert(std::is_trivially_copyable_v<ComponentImage>);

bool isProxy(GLenum image) {
  switch (image) {
  case GL_PROXY_TEXTURE_1D:
  case GL_PROXY_TEXTURE_2D:
  case GL_PROXY_TEXTURE_3D:
  case GL_PROXY_TEXTURE_CUBE_MAP:
  case GL_PROXY_TEXTURE_RECTANGLE:
    return true;
  default:
    return false;
  }
}

GLuint boundTo(const ProgramContext &context, GLenum image) {
  GLint name = 0;
  if (const GLenum binding = bindingOf(image))
    context.host->GetIntegerv(binding, &name);
  return GLuint(name);
}

/// A component of the format: its index in the transfers, its sign, and its bits.
struct Component {
  std::size_t transfer;
  bool isSigned;
  int bits;
};
Component componentOf(const ComponentFormat &format, int number) {
  if (format.base == Base::Hilo)
    return {std::size_t(number), format.signs == Signs::Signed, format.bits[6]};
  return {2 + std::size_t(number), number < 2, 8};
}

/// Adds the third component that programs see in HILO formats: 1, or that of a unit vector
/// (NV_fragment_program, table X.5).
std::vector<GLfloat> withThird(const std::vector<GLfloat> &pixels, bool isSigned) {
  std::vector<GLfloat> wide;
  wide.reserve(pixels.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
    const GLfloat hi = pixels[i], lo = pixels[i + 1];
    const GLfloat third = isSigned ? std::sqrt(std::max(0.0f, 1.0f - hi * hi - lo * lo)) : 1.0f;
    wide.insert(wide.end(), {hi, lo, third});
  }
  return wide;
}

/// Converts pixels: scale and bias (3.6.5), clamping (3.8.1), rounding to the internal format, and
/// the third component that the host stores.
void convert(const ComponentTransfers &transfers, const ComponentFormat &format,
             std::vector<GLfloat> &pixels) {
  const auto count = std::size_t(format.components());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Component to = componentOf(format, int(i % count));
    const GLfloat wide =
        format.base == Base::Dudv // it has no scale
            ? pixels[i]
            : pixels[i] * transfers.scales[to.transfer] + transfers.biases[to.transfer];
    const GLfloat low = to.isSigned ? -1.0f : 0.0f;
    const GLfloat value = wide > low ? std::min(wide, 1.0f) : low; // NaN becomes the smallest value
    const double steps = double((1 << (to.isSigned ? to.bits - 1 : to.bits)) - 1);
    pixels[i] = GLfloat(std::round(double(value) * steps) / steps);
  }
  if (format.base == Base::Hilo)
    pixels = withThird(pixels, format.signs == Signs::Signed);
}

GLenum hostFormatOf(const ComponentFormat &format) {
  constexpr GLenum kHostFormats[] = {GL_RG, GL_RGB, GL_RGBA};
  return format.base == Base::Hilo ? GLenum(GL_RGB) : kHostFormats[format.components() - 2];
}

void define(const host::HostTable &host, const ComponentImage &image, GLint internal, GLenum format,
            const void *pixels) {
  switch (image.dimensions) {
  case 1:
    return host.TexImage1D(image.target, image.level, internal, image.width, image.border, format,
                           GL_FLOAT, pixels);
  case 3:
    return host.TexImage3D(image.target, image.level, internal, image.width, image.height,
                           image.depth, image.border, format, GL_FLOAT, pixels);
  default:
    return host.TexImage2D(image.target, image.level, internal, image.width, image.height,
                           image.border, format, GL_FLOAT, pixels);
  }
}

void replace(const host::HostTable &host, const ComponentImage &image, GLenum format,
             const void *pixels) {
  switch (image.dimensions) {
  case 1:
    return host.TexSubImage1D(image.target, image.level, image.x, image.width, format, GL_FLOAT,
                              pixels);
  case 3:
    return host.TexSubImage3D(image.target, image.level, image.x, image.y, image.z, image.width,
                              image.height, image.depth, format, GL_FLOAT, pixels);
  default:
    return host.TexSubImage2D(image.target, image.level, image.x, image.y, image.width,
                              image.height, format, GL_FLOAT, pixels);
  }
}

/// Sends the pixels to the host as floats. \returns the host's error
GLenum upload(ProgramContext &context, const ComponentImage &image, const ComponentFormat &format,
              const std::vector<GLfloat> &pixels) {
  const PlainTransfer plain(context, PixelStore::Unpack);
  const void *const data = image.hasPixels != 0 ? pixels.data() : nullptr;
  const GLenum external = hostFormatOf(format);
  if (image.replaces != 0)
    replace(*context.host, image, external, data);
  else
    define(*context.host, image, GLint(format.host), external, data);
  return takeHostErrors(*context.host);
}

} // namespace

bool mayHaveSize(const ProgramContext &context, const ComponentImage &image) {
  GLint most = 0;
  context.host->GetIntegerv(image.target == GL_TEXTURE_3D          ? GL_MAX_3D_TEXTURE_SIZE
                            : image.target == GL_TEXTURE_RECTANGLE ? GL_MAX_RECTANGLE_TEXTURE_SIZE
                                                                   : GL_MAX_TEXTURE_SIZE,
                            &most);
  most += 2; // allows for borders
  return image.width <= most && image.height <= most && image.depth <= most;
}

GLenum componentFormatOf(ProgramContext &context, GLenum image, GLint level) {
  TextureFormats &formats = context.group->textureFormats;
  const GLenum name = formats.any() ? formats.find(boundTo(context, image), image, level) : 0;
  const ComponentFormat *const format = componentFormat(name);
  if (!format)
    return 0;
  // Commands that the layer does not see (CompressedTexImage, TexStorage) may have given it another
  // format.
  GLint there = 0;
  context.host->GetTexLevelParameteriv(image, level, GL_TEXTURE_INTERNAL_FORMAT, &there);
  return GLenum(there) == hostFormat(*format, context.caps) ? name : 0;
}

void noteImageFormat(ProgramContext &context, GLenum image, GLint level, GLenum internalFormat) {
  const bool first = internalFormat != 0 && !context.group->textureFormats.any();
  context.group->textureFormats.set(boundTo(context, image), image, level, internalFormat);
  context.textureShaders->wholeTextures.clear();
  context.textureShaders->used = context.textureShaders->used || internalFormat != 0;
  noteTextureChange(context);
  if (first && !isProxy(image))
    invalidateProgram(context); // makes draws look from now on
}

void executeComponentImage(ProgramContext &context, const ComponentImage &image,
                           std::vector<GLfloat> pixels) {
  const bool replaces = image.replaces != 0;
  const GLenum internal =
      replaces ? componentFormatOf(context, image.target, image.level) : image.internalFormat;
  const ComponentFormat *const format =
      componentFormat(internal, context.textureShaders->extensions());
  if (!format || format->external != image.format)
    return raise(context, GL_INVALID_OPERATION, "TexImage: the image has no such components");
  if (!isProxy(image.target) && !mayHaveSize(context, image))
    return raise(context, GL_INVALID_VALUE, "TexImage: a size is beyond the host's");
  if (image.hasPixels != 0)
    convert(context.textureShaders->transfers, *format, pixels);
  if (const GLenum error = upload(context, image, *format, pixels); error != GL_NO_ERROR)
    return raise(context, error, "TexImage: the host refuses it");
  if (!replaces)
    noteImageFormat(context, image.target, image.level, internal);
}

std::string bytesOf(const ComponentImage &image, const std::vector<GLfloat> &pixels) {
  std::string bytes(reinterpret_cast<const char *>(&image), sizeof image);
  bytes.append(reinterpret_cast<const char *>(pixels.data()), pixels.size() * sizeof(GLfloat));
  return bytes;
}

ComponentImage componentImageOf(const std::string &bytes) {
  ComponentImage image;
  std::memcpy(&image, bytes.data(), sizeof image);
  return image;
}

void executeComponentImage(ProgramContext &context, const std::string &bytes) {
  if (!mayKeepTextures(context))
    return raise(context, GL_INVALID_OPERATION, "a list's image of NV_texture_shader");
  keepTextures(context);
  const ComponentImage image = componentImageOf(bytes);
  std::vector<GLfloat> pixels((bytes.size() - sizeof image) / sizeof(GLfloat));
  std::memcpy(pixels.data(), bytes.data() + sizeof image, pixels.size() * sizeof(GLfloat));
  executeComponentImage(context, image, std::move(pixels));
}

} // namespace arbiter::state
