#include "state/programs/texture_shaders/component_texels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/programs/texture_shaders/component_formats.h"

namespace arbiter::state {

namespace {

GLint get(const Context &context, GLenum name) {
  GLint value = 0;
  context.host->GetIntegerv(name, &value);
  return value;
}

std::size_t bytesOf(GLenum type) {
  switch (type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE:
    return 1;
  case GL_SHORT:
  case GL_UNSIGNED_SHORT:
  case GL_HALF_FLOAT:
    return 2;
  case GL_INT:
  case GL_UNSIGNED_INT:
  case GL_FLOAT:
  case GL_UNSIGNED_INT_S8_S8_8_8_NV:
  case GL_UNSIGNED_INT_8_8_S8_S8_REV_NV:
    return 4;
  default:
    return 0;
  }
}

/// Where texels lie in memory (3.6.4, Unpacking).
struct Layout {
  std::size_t element, texel, row, image, first, end;
};

Layout layoutOf(const Context &context, const ComponentPixels &pixels, bool pack) {
  const auto store = [&](GLenum packName, GLenum unpackName) {
    return std::size_t(std::max(get(context, pack ? packName : unpackName), 0));
  };
  const std::size_t alignment = store(GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT);
  const std::size_t length = store(GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH);
  const bool deep = pixels.dimensions == 3;
  const std::size_t rows =
      deep ? store(GL_PACK_IMAGE_HEIGHT, GL_UNPACK_IMAGE_HEIGHT) : std::size_t(0);
  const std::size_t images =
      deep ? store(GL_PACK_SKIP_IMAGES, GL_UNPACK_SKIP_IMAGES) : std::size_t(0);
  const auto width = std::size_t(pixels.width), height = std::size_t(pixels.height);
  Layout layout{};
  layout.element = bytesOf(pixels.type);
  layout.texel =
      layout.element * (isSignedPacked(pixels.type) ? 1 : std::size_t(pixels.components));
  layout.row = layout.texel * (length != 0 ? length : width);
  if (layout.element < alignment)
    layout.row = (layout.row + alignment - 1) / alignment * alignment;
  layout.image = layout.row * (rows != 0 ? rows : height);
  layout.first = images * layout.image +
                 store(GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_ROWS) * layout.row +
                 store(GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS) * layout.texel;
  layout.end = layout.first + (std::size_t(pixels.depth) - 1) * layout.image +
               (height - 1) * layout.row + width * layout.texel;
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
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
  if (exponent == 31)
    return fraction != 0 ? 0.0f : GLfloat(sign * HUGE_VAL);
  return exponent == 0 ? GLfloat(sign * std::ldexp(fraction, -24))
                       : GLfloat(sign * std::ldexp(1024 + fraction, exponent - 25));
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

/// The four components of a packed type, two of them signed.
void packed(std::uint32_t word, GLenum type, GLfloat *to) {
  const bool reversed = type == GL_UNSIGNED_INT_8_8_S8_S8_REV_NV;
  for (int i = 0; i < 4; ++i) {
    const auto byte = std::uint8_t(word >> (reversed ? 8 * i : 24 - 8 * i));
    to[i] = i < 2 ? signedValue(std::int8_t(byte)) : unsignedValue(byte);
  }
}
std::uint32_t word(const GLfloat *from, GLenum type) {
  const bool reversed = type == GL_UNSIGNED_INT_8_8_S8_S8_REV_NV;
  std::uint32_t result = 0;
  for (int i = 0; i < 4; ++i) {
    const auto byte = std::uint8_t(i < 2 ? std::lround(std::clamp(from[i], -1.0f, 1.0f) * 127.0f)
                                         : std::lround(std::clamp(from[i], 0.0f, 1.0f) * 255.0f));
    result |= std::uint32_t(byte) << (reversed ? 8 * i : 24 - 8 * i);
  }
  return result;
}

/// A pixel buffer that holds so many bytes from an offset on; an error else.
bool bufferHolds(Context &context, GLenum target, std::size_t offset, std::size_t bytes) {
  GLint size = 0, mapped = 0;
  context.host->GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
  context.host->GetBufferParameteriv(target, GL_BUFFER_MAPPED, &mapped);
  if (mapped == 0 && offset + bytes <= std::size_t(size))
    return true;
  raise(context, GL_INVALID_OPERATION, "pixels reach out of the pixel buffer, or it is mapped");
  return false;
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
    return bytesOf(type) != 0 ? GL_NO_ERROR : GL_INVALID_ENUM;
  }
}

bool unpackComponents(Context &context, const ComponentPixels &pixels, const void *from,
                      std::vector<GLfloat> &to) {
  const Layout layout = layoutOf(context, pixels, false);
  const auto *bytes = static_cast<const std::uint8_t *>(from);
  std::vector<std::uint8_t> buffer;
  if (context.caps.pixelBuffers && get(context, GL_PIXEL_UNPACK_BUFFER_BINDING) != 0) {
    const auto offset = std::size_t(from);
    if (!bufferHolds(context, GL_PIXEL_UNPACK_BUFFER, offset, layout.end))
      return false;
    buffer.resize(layout.end);
    context.host->GetBufferSubData(GL_PIXEL_UNPACK_BUFFER, GLintptr(offset), GLsizeiptr(layout.end),
                                   buffer.data());
    bytes = buffer.data();
  }
  const bool swaps = get(context, GL_UNPACK_SWAP_BYTES) != 0;
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

bool packSignedBytes(Context &context, const ComponentPixels &pixels,
                     const std::vector<GLfloat> &from, void *to) {
  const Layout layout = layoutOf(context, pixels, true);
  const bool swaps = get(context, GL_PACK_SWAP_BYTES) != 0;
  const bool buffered =
      context.caps.pixelBuffers && get(context, GL_PIXEL_PACK_BUFFER_BINDING) != 0;
  if (buffered && !bufferHolds(context, GL_PIXEL_PACK_BUFFER, std::size_t(to), layout.end))
    return false;
  forEachTexel(pixels, layout, [&](std::size_t index, std::size_t at) {
    std::uint32_t value = word(&from[index * 4], pixels.type);
    if (swaps)
      value = value >> 24 | (value >> 8 & 0xFF00) | (value << 8 & 0xFF0000) | value << 24;
    if (buffered)
      context.host->BufferSubData(GL_PIXEL_PACK_BUFFER, GLintptr(std::size_t(to) + at), 4, &value);
    else
      std::memcpy(static_cast<std::uint8_t *>(to) + at, &value, sizeof value);
  });
  return true;
}

} // namespace arbiter::state
