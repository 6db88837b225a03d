#include "state/programs/texture_shaders/component_texels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/client_pixels/client_image.h"
#include "state/core/errors.h"
#include "state/programs/program_context.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "util/numbers/half.h"

namespace arbiter::state {

namespace {

/// Returns the size of a component, or of a texel of a packed type; 0 for an invalid type.
std::size_t bytesOfType(GLenum type) { return isSignedPacked(type) ? 4 : componentBytes(type); }

/// The layout of texels in memory.
struct Layout : ImageLayout {
  std::size_t element = 0, texel = 0;
};

Layout layoutOf(const ProgramContext &context, const ComponentPixels &pixels, PixelStore store) {
  Layout layout;
  layout.element = bytesOfType(pixels.type);
  layout.texel =
      layout.element * (isSignedPacked(pixels.type) ? 1 : std::size_t(pixels.components));
  const ImageSize size{pixels.dimensions, std::size_t(pixels.width), std::size_t(pixels.height),
                       std::size_t(pixels.depth)};
  static_cast<ImageLayout &>(layout) = layoutOf(context, store, size, layout.element, layout.texel);
  return layout;
}

template <typename T> T read(const std::uint8_t *at, bool swaps) {
  std::uint8_t bytes[sizeof(T)];
  std::memcpy(bytes, at, sizeof bytes);
  if (swaps)
    std::reverse(std::begin(bytes), std::end(bytes));
  return std::bit_cast<T>(bytes);
}

GLfloat half(std::uint16_t bits) {
  const float value = halfToFloat(bits);
  return std::isnan(value) ? 0.0f : value;
}

template <typename T> GLfloat signedValue(T value) {
  return GLfloat(std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0));
}
template <typename T> GLfloat unsignedValue(T value) {
  return GLfloat(double(value) / double(std::numeric_limits<T>::max()));
}

GLfloat component(const std::uint8_t *at, GLenum type, bool swaps) {
  switch (type) {
  case GL_BYTE:
    return signedValue(std::int8_t(*at));
  case GL_UNSIGNED_BYTE:
    return unsignedValue(*at);
  case GL_SHORT:
    return signedValue(read<std::int16_t>(at, swaps));
  case GL_UNSIGNED_SHORT:
    return unsignedValue(read<std::uint16_t>(at, swaps));
  case GL_INT:
    return signedValue(read<std::int32_t>(at, swaps));
  case GL_UNSIGNED_INT:
    return unsignedValue(read<std::uint32_t>(at, swaps));
  case GL_HALF_FLOAT:
    return half(read<std::uint16_t>(at, swaps));
  default:
    return read<GLfloat>(at, swaps);
  }
}

/// Unpacks the four components of a packed type; two of them are signed.
void packed(std::uint32_t word, GLenum type, GLfloat *to) {
  const bool reversed = type == GL_UNSIGNED_INT_8_8_S8_S8_REV_NV;
  for (int i = 0; i < 4; ++i) {
    const auto byte = std::uint8_t(word >> (reversed ? 8 * i : 24 - 8 * i));
    to[i] = i < 2 ? signedValue(std::int8_t(byte)) : unsignedValue(byte);
  }
}
template <typename T> void write(T value, bool swaps, std::uint8_t *to) {
  std::memcpy(to, &value, sizeof value);
  if (swaps)
    std::reverse(to, to + sizeof value);
}

template <typename T> T integer(GLfloat value) {
  const double least = std::numeric_limits<T>::is_signed ? -1 : 0;
  return T(
      std::llround(std::clamp(double(value), least, 1.0) * double(std::numeric_limits<T>::max())));
}

std::uint32_t word(const GLfloat *from, GLenum type) {
  const bool reversed = type == GL_UNSIGNED_INT_8_8_S8_S8_REV_NV;
  std::uint32_t result = 0;
  for (int i = 0; i < 4; ++i) {
    const auto byte =
        i < 2 ? std::uint8_t(integer<std::int8_t>(from[i])) : integer<std::uint8_t>(from[i]);
    result |= std::uint32_t(byte) << (reversed ? 8 * i : 24 - 8 * i);
  }
  return result;
}

void writeComponent(GLfloat value, GLenum type, bool swaps, std::uint8_t *to) {
  switch (type) {
  case GL_BYTE:
    return write(integer<std::int8_t>(value), swaps, to);
  case GL_UNSIGNED_BYTE:
    return write(integer<std::uint8_t>(value), swaps, to);
  case GL_SHORT:
    return write(integer<std::int16_t>(value), swaps, to);
  case GL_UNSIGNED_SHORT:
    return write(integer<std::uint16_t>(value), swaps, to);
  case GL_INT:
    return write(integer<std::int32_t>(value), swaps, to);
  default:
    return write(integer<std::uint32_t>(value), swaps, to);
  }
}

template <typename Visit>
void forEachTexel(const ComponentPixels &pixels, const Layout &layout, Visit visit) {
  std::size_t index = 0;
  for (GLsizei z = 0; z < pixels.depth; ++z)
    for (GLsizei y = 0; y < pixels.height; ++y)
      for (GLsizei x = 0; x < pixels.width; ++x)
        visit(index++, layout.first + std::size_t(z) * layout.image + std::size_t(y) * layout.row +
                           std::size_t(x) * layout.texel);
}

} // namespace

GLenum componentTypeError(GLenum format, GLenum type) {
  if (isSignedPacked(type))
    return format == GL_DSDT_MAG_VIB_NV ? GL_NO_ERROR : GL_INVALID_OPERATION;
  switch (type) {
  case GL_UNSIGNED_BYTE_3_3_2:
  case GL_UNSIGNED_BYTE_2_3_3_REV:
  case GL_UNSIGNED_SHORT_5_6_5:
  case GL_UNSIGNED_SHORT_5_6_5_REV:
  case GL_UNSIGNED_SHORT_4_4_4_4:
  case GL_UNSIGNED_SHORT_4_4_4_4_REV:
  case GL_UNSIGNED_SHORT_5_5_5_1:
  case GL_UNSIGNED_SHORT_1_5_5_5_REV:
  case GL_UNSIGNED_INT_8_8_8_8:
  case GL_UNSIGNED_INT_8_8_8_8_REV:
  case GL_UNSIGNED_INT_10_10_10_2:
  case GL_UNSIGNED_INT_2_10_10_10_REV:
    return GL_INVALID_OPERATION;
  default:
    return bytesOfType(type) != 0 ? GL_NO_ERROR : GL_INVALID_ENUM;
  }
}

bool unpackComponents(ProgramContext &context, const ComponentPixels &pixels, const void *from,
                      std::vector<GLfloat> &to) {
  const Layout layout = layoutOf(context, pixels, PixelStore::Unpack);
  const auto *bytes = static_cast<const std::uint8_t *>(from);
  std::vector<std::uint8_t> buffer;
  if (hasPixelBuffer(context, PixelStore::Unpack)) {
    const auto offset = std::size_t(from);
    if (!pixelBufferHolds(context, PixelStore::Unpack, offset, layout.end))
      return false;
    buffer.resize(layout.end);
    context.host->GetBufferSubData(GL_PIXEL_UNPACK_BUFFER, GLintptr(offset), GLsizeiptr(layout.end),
                                   buffer.data());
    bytes = buffer.data();
  }
  const bool swaps = hostInteger(*context.host, GL_UNPACK_SWAP_BYTES) != 0;
  const auto count = std::size_t(pixels.components);
  to.resize(std::size_t(pixels.width) * std::size_t(pixels.height) * std::size_t(pixels.depth) *
            count);
  forEachTexel(pixels, layout, [&](std::size_t index, std::size_t at) {
    GLfloat *const texel = &to[index * count];
    if (isSignedPacked(pixels.type))
      return packed(read<std::uint32_t>(bytes + at, swaps), pixels.type, texel);
    for (std::size_t c = 0; c < count; ++c)
      texel[c] = component(bytes + at + c * layout.element, pixels.type, swaps);
  });
  return true;
}

bool isPackedHere(GLenum type) { return type != GL_FLOAT && type != GL_HALF_FLOAT; }

bool packComponents(ProgramContext &context, const ComponentPixels &pixels,
                    const std::vector<GLfloat> &from, void *to) {
  const Layout layout = layoutOf(context, pixels, PixelStore::Pack);
  const bool swaps = hostInteger(*context.host, GL_PACK_SWAP_BYTES) != 0;
  const bool buffered = hasPixelBuffer(context, PixelStore::Pack);
  if (buffered && !pixelBufferHolds(context, PixelStore::Pack, std::size_t(to), layout.end))
    return false;
  const auto count = std::size_t(pixels.components);
  forEachTexel(pixels, layout, [&](std::size_t index, std::size_t at) {
    const GLfloat *const texel = &from[index * count];
    std::uint8_t bytes[16];
    if (isSignedPacked(pixels.type))
      write(word(texel, pixels.type), swaps, bytes);
    else
      for (std::size_t c = 0; c < count; ++c)
        writeComponent(texel[c], pixels.type, swaps, bytes + c * layout.element);
    if (buffered)
      context.host->BufferSubData(GL_PIXEL_PACK_BUFFER, GLintptr(std::size_t(to) + at),
                                  GLsizeiptr(layout.texel), bytes);
    else
      std::memcpy(static_cast<std::uint8_t *>(to) + at, bytes, layout.texel);
  });
  return true;
}

} // namespace arbiter::state
