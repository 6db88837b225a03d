#include "fp_compiler/ir/packing.h"

#include <bit>
#include <cmath>

#include "util/numbers/half.h"

namespace arbiter::fp::ir {

namespace {
std::uint32_t scaled(float value, float least, float scale, float offset) {
  if (std::isnan(value))
    value = least;
  const float clamped = value < least ? least : value > 1.0f ? 1.0f : value;
  return std::uint32_t(std::nearbyint(scale * clamped + offset));
}

constexpr float kLeastSigned = -128.0f / 127.0f;

std::uint32_t unsignedWord(float value) { return scaled(value, 0.0f, 65535.0f, 0.0f); }
std::uint32_t unsignedByte(float value) { return scaled(value, 0.0f, 255.0f, 0.0f); }
std::uint32_t signedByte(float value) { return scaled(value, kLeastSigned, 127.0f, 128.0f); }

template <typename F> std::uint32_t bytes(const Vec4 &value, F byte) {
  return byte(value[0]) | byte(value[1]) << 8 | byte(value[2]) << 16 | byte(value[3]) << 24;
}

std::uint32_t bitsOf(Packing packing, const Vec4 &value) {
  switch (packing) {
  case Packing::Half2:
    return std::uint32_t(halfOf(value[0])) | std::uint32_t(halfOf(value[1])) << 16;
  case Packing::Unsigned2:
    return unsignedWord(value[0]) | unsignedWord(value[1]) << 16;
  case Packing::Signed4:
    return bytes(value, signedByte);
  case Packing::Unsigned4:
    break;
  }
  return bytes(value, unsignedByte);
}
} // namespace

std::uint16_t halfOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = std::uint16_t(bits >> 16 & 0x8000);
  const std::uint32_t size = bits & 0x7FFFFFFF;
  if (size > 0x7F800000)
    return 0x7FFF;        // all NaNs give the same half, whatever their sign
  if (size >= 0x477FF000) // 65520 and above
    return std::uint16_t(sign | 0x7C00);
  if (size < 0x38800000) // below 2^-14 the unit of a half is 2^-24
    return std::uint16_t(sign | std::uint16_t(std::nearbyint(std::fabs(value) * 0x1p24f)));
  const std::uint32_t near = size + 0xFFF + (size >> 13 & 1);
  return std::uint16_t(sign | ((near - 0x38000000) >> 13));
}

Vec4 packed(Packing packing, const Vec4 &value) {
  const std::uint32_t bits = bitsOf(packing, value);
  return std::bit_cast<Vec4>(std::array{bits, bits, bits, bits});
}

Vec4 unpacked(Packing packing, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto byte = [&](int i) { return bits >> (8 * i) & 0xFF; };
  switch (packing) {
  case Packing::Half2: {
    const float low = halfToFloat(std::uint16_t(bits)),
                high = halfToFloat(std::uint16_t(bits >> 16));
    return {low, high, low, high};
  }
  case Packing::Unsigned2: {
    const float low = float(bits & 0xFFFF) / 65535.0f, high = float(bits >> 16) / 65535.0f;
    return {low, high, low, high};
  }
  case Packing::Signed4: {
    const auto number = [&](int i) { return (float(byte(i)) - 128.0f) / 127.0f; };
    return {number(0), number(1), number(2), number(3)};
  }
  case Packing::Unsigned4:
    break;
  }
  const auto number = [&](int i) { return float(byte(i)) / 255.0f; };
  return {number(0), number(1), number(2), number(3)};
}

} // namespace arbiter::fp::ir
