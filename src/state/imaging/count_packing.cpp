#include "state/imaging/count_packing.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/client_pixels/client_image.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"
#include "state/imaging/pixel_types.h"

namespace arbiter::state {

namespace {

using imaging::Counts;

template <typename T> void put(std::uint32_t count, std::uint8_t *to) {
  const T value = T(std::min<std::uint64_t>(count, std::uint64_t(std::numeric_limits<T>::max())));
  std::memcpy(to, &value, sizeof value);
}

void putComponent(std::uint32_t count, GLenum type, std::uint8_t *to) {
  switch (type) {
  case GL_BYTE:
    return put<std::int8_t>(count, to);
  case GL_UNSIGNED_BYTE:
    return put<std::uint8_t>(count, to);
  case GL_SHORT:
    return put<std::int16_t>(count, to);
  case GL_UNSIGNED_SHORT:
    return put<std::uint16_t>(count, to);
  case GL_INT:
    return put<std::int32_t>(count, to);
  case GL_UNSIGNED_INT:
    return put<std::uint32_t>(count, to);
  default:
    const auto value = float(count);
    std::memcpy(to, &value, sizeof value);
  }
}

void putPacked(const Counts &bin, const std::vector<int> &components, const PackedType &type,
               std::uint8_t *to) {
  std::uint32_t word = 0;
  int place = type.reversed ? 0 : int(type.bytes * 8);
  for (std::size_t c = 0; c < components.size(); ++c) {
    const int bits = type.bits[c];
    const std::uint32_t most = (1u << bits) - 1;
    if (!type.reversed)
      place -= bits;
    word |= std::min(bin[std::size_t(components[c])], most) << place;
    if (type.reversed)
      place += bits;
  }
  std::memcpy(to, &word, type.bytes); // the least significant bytes
}

/// Writes to memory, or to the pixel buffer.
bool store(CoreContext &context, const std::vector<std::uint8_t> &bytes, std::size_t first,
           void *to) {
  if (!hasPixelBuffer(context, PixelStore::Pack)) {
    if (!bytes.empty()) // an empty table writes nothing, whatever `to` is
      std::memcpy(static_cast<std::uint8_t *>(to) + first, bytes.data(), bytes.size());
    return true;
  }
  const std::size_t at = std::size_t(to) + first;
  if (!pixelBufferHolds(context, PixelStore::Pack, at, bytes.size()))
    return false;
  context.host->BufferSubData(GL_PIXEL_PACK_BUFFER, GLintptr(at), GLsizeiptr(bytes.size()),
                              bytes.data());
  return true;
}

void swapBytes(std::vector<std::uint8_t> &bytes, std::size_t element) {
  for (std::size_t at = 0; at + element <= bytes.size(); at += element)
    std::reverse(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + element));
}

/// Returns the error that the host raises for this format and type.
GLenum errorOf(const std::vector<int> &components, const PackedType *packed, GLenum type) {
  if (components.empty() || (!packed && (componentBytes(type) == 0 || type == GL_HALF_FLOAT)))
    return GL_INVALID_ENUM;
  const bool three = packed && packed->bits[3] == 0;
  return packed && components.size() != (three ? 3u : 4u) ? GLenum(GL_INVALID_OPERATION)
                                                          : GLenum(GL_NO_ERROR);
}

} // namespace

bool packCounts(CoreContext &context, const std::vector<Counts> &bins, GLenum format, GLenum type,
                void *to) {
  const std::vector<int> components = componentsOfQuery(format);
  const PackedType *const packed = packedType(type);
  if (const GLenum error = errorOf(components, packed, type); error != GL_NO_ERROR) {
    raise(context, error, "GetHistogram: format or type");
    return false;
  }
  const std::size_t element = packed ? packed->bytes : componentBytes(type);
  const std::size_t pixel = packed ? element : element * components.size();
  std::vector<std::uint8_t> bytes(pixel * bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    std::uint8_t *const at = &bytes[i * pixel];
    if (packed)
      putPacked(bins[i], components, *packed, at);
    for (std::size_t c = 0; !packed && c < components.size(); ++c)
      putComponent(bins[i][std::size_t(components[c])], type, at + c * element);
  }
  if (hostInteger(*context.host, GL_PACK_SWAP_BYTES) != 0)
    swapBytes(bytes, element);
  const ImageSize size{.width = bins.size(), .height = 1};
  return bins.empty() ||
         store(context, bytes, layoutOf(context, PixelStore::Pack, size, element, pixel).first, to);
}

} // namespace arbiter::state
