#include "swrast/image/pixel_values.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "util/numbers/half.h"

namespace arbiter::swrast {
namespace {

using abi::Layout;

enum class Kind : std::uint8_t { None, U8, U16, F16, F32, Packed };

Kind kindOf(Layout layout) {
  switch (layout) {
  case Layout::U8x1:
  case Layout::U8x2:
  case Layout::U8x4:
    return Kind::U8;
  case Layout::U16x1:
  case Layout::U16x2:
  case Layout::U16x4:
    return Kind::U16;
  case Layout::F16x1:
  case Layout::F16x2:
  case Layout::F16x4:
    return Kind::F16;
  case Layout::F32x1:
  case Layout::F32x2:
  case Layout::F32x4:
    return Kind::F32;
  default:
    return abi::isPacked(layout) ? Kind::Packed : Kind::None;
  }
}

float loadBits(Layout layout, const std::uint8_t *pixel, int component) {
  std::uint32_t word = 0;
  std::memcpy(&word, pixel, std::size_t(abi::bytesOf(layout)));
  const abi::BitField field = abi::bitsOf(layout, component);
  const std::uint32_t most = (1u << field.bits) - 1;
  return float(word >> field.shift & most) / float(most);
}

float load(Kind kind, const std::uint8_t *pixel, int component) {
  std::uint16_t bits = 0;
  switch (kind) {
  case Kind::U8:
    return float(pixel[component]) / 255.0f;
  case Kind::U16:
    std::memcpy(&bits, pixel + 2 * component, 2);
    return float(bits) / 65535.0f;
  case Kind::F16:
    std::memcpy(&bits, pixel + 2 * component, 2);
    return halfToFloat(bits);
  case Kind::F32: {
    float value = 0;
    std::memcpy(&value, pixel + 4 * component, 4);
    return value;
  }
  case Kind::Packed:
  case Kind::None:
    break;
  }
  return 0;
}

/// Scales [0, 1] to [0, largest] and rounds; NaN becomes 0.
float scaled(float value, float largest) {
  if (!(value > 0))
    return 0;
  return value >= 1 ? largest : std::floor(value * largest + 0.5f);
}

/// Converts to the nearest byte as hosts round a clear colour. The float sum keeps only 8 bits
/// below the byte, so values close to a half round to even.
std::uint8_t toByte(float value) {
  if (!(value > 0))
    return 0;
  return value >= 1
             ? 255
             : std::uint8_t(std::bit_cast<std::uint32_t>(value * (255.0f / 256.0f) + 32768.0f));
}

void storeBits(Layout layout, std::uint8_t *pixel, int component, float value) {
  std::uint32_t word = 0;
  std::memcpy(&word, pixel, std::size_t(abi::bytesOf(layout)));
  const abi::BitField field = abi::bitsOf(layout, component);
  const std::uint32_t most = (1u << field.bits) - 1;
  word &= ~(most << field.shift);
  word |= std::uint32_t(scaled(value, float(most))) << field.shift;
  std::memcpy(pixel, &word, std::size_t(abi::bytesOf(layout)));
}

void store(Kind kind, std::uint8_t *pixel, int component, float value) {
  std::uint16_t bits = 0;
  switch (kind) {
  case Kind::U8:
    pixel[component] = toByte(value);
    return;
  case Kind::U16:
    bits = std::uint16_t(scaled(value, 65535));
    std::memcpy(pixel + 2 * component, &bits, 2);
    return;
  case Kind::F16:
    bits = floatToHalf(value);
    std::memcpy(pixel + 2 * component, &bits, 2);
    return;
  case Kind::F32:
    std::memcpy(pixel + 4 * component, &value, 4);
    return;
  case Kind::Packed:
  case Kind::None:
    return;
  }
}

} // namespace

int sourceOf(const abi::Swizzle &swizzle, int stored) {
  for (int component = 0; component < 4; ++component)
    if (int(swizzle[std::size_t(component)]) == stored)
      return component;
  return 4;
}

std::uint16_t floatToHalf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = std::uint16_t((bits >> 16) & 0x8000u);
  const std::uint32_t magnitude = bits & 0x7FFFFFFFu;
  if (magnitude >= 0x7F800000u) // infinity or NaN
    return std::uint16_t(sign | (magnitude > 0x7F800000u ? 0x7E00u : 0x7C00u));
  if (magnitude >= 0x47800000u) // 65536
    return std::uint16_t(sign | 0x7BFFu);
  // below 2^-14, the smallest normal number: denormals in units of 2^-24
  if (magnitude < 0x38800000u) {
    const float units = std::ldexp(std::bit_cast<float>(magnitude), 24);
    return std::uint16_t(sign | std::uint16_t(units));
  }
  return std::uint16_t(sign | ((magnitude - 0x38000000u) >> 13));
}

void unpackPixels(const abi::Format &format, const std::uint8_t *pixels, int count,
                  float (*rgba)[4]) {
  const Kind kind = kindOf(format.layout);
  const int bytes = abi::bytesOf(format.layout), components = abi::componentsOf(format.layout);
  for (int i = 0; i < count; ++i, pixels += bytes) {
    for (int c = 0; c < 4; ++c) {
      const abi::From from = format.swizzle[std::size_t(c)];
      if (int(from) < components)
        rgba[i][c] = kind == Kind::Packed ? loadBits(format.layout, pixels, int(from))
                                          : load(kind, pixels, int(from));
      else
        rgba[i][c] = from == abi::From::One ? 1.0f : 0.0f;
    }
  }
}

void packPixels(const abi::Format &format, const float (*rgba)[4], int count, std::uint8_t *pixels,
                unsigned writeMask) {
  const Kind kind = kindOf(format.layout);
  const int bytes = abi::bytesOf(format.layout), components = abi::componentsOf(format.layout);
  for (int stored = 0; stored < components; ++stored) {
    const int source = sourceOf(format.swizzle, stored);
    if (source < 4 && !((writeMask >> source) & 1u))
      continue;
    for (int i = 0; i < count; ++i) {
      std::uint8_t *const pixel = pixels + std::ptrdiff_t(i) * bytes;
      const float value = source < 4 ? rgba[i][source] : 1.0f;
      if (kind == Kind::Packed)
        storeBits(format.layout, pixel, stored, value);
      else
        store(kind, pixel, stored, value);
    }
  }
}

} // namespace arbiter::swrast
