#include "fp_compiler/back/llvm/testing/reference_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>

/// Reads texels for the reference sampler.
namespace arbiter::fp::llvm_back::testing {
namespace {

using abi::Layout;

double halfToDouble(std::uint16_t half) {
  const double sign = half & 0x8000 ? -1 : 1;
  const int exponent = half >> 10 & 31, mantissa = half & 1023;
  if (exponent == 31)
    return mantissa ? std::nan("") : sign * HUGE_VAL;
  return sign * (exponent ? std::ldexp(1024 + mantissa, exponent - 25) : std::ldexp(mantissa, -24));
}

double component(Layout layout, const std::uint8_t *bytes, int index) {
  std::uint16_t half = 0;
  std::uint32_t word = 0;
  float real = 0;
  switch (layout) {
  case Layout::U8x1:
  case Layout::U8x2:
  case Layout::U8x4:
    return bytes[index] / 255.0;
  case Layout::U16x1:
  case Layout::U16x2:
  case Layout::U16x4:
  case Layout::Depth16:
    std::memcpy(&half, bytes + 2 * index, 2);
    return half / 65535.0;
  case Layout::F16x1:
  case Layout::F16x2:
  case Layout::F16x4:
    std::memcpy(&half, bytes + 2 * index, 2);
    return halfToDouble(half);
  case Layout::F32x1:
  case Layout::F32x2:
  case Layout::F32x4:
  case Layout::Depth32F:
    std::memcpy(&real, bytes + 4 * index, 4);
    return double(real);
  case Layout::Depth32:
    std::memcpy(&word, bytes, 4);
    return word / 4294967295.0;
  case Layout::Depth24Stencil8:
    std::memcpy(&word, bytes, 4);
    return (word >> 8) / 16777215.0;
  case Layout::Bits565:
  case Layout::Bits4444:
  case Layout::Bits5551:
  case Layout::Bits1010102: {
    std::memcpy(&word, bytes, std::size_t(abi::bytesOf(layout)));
    const abi::BitField field = abi::bitsOf(layout, index);
    const double most = std::ldexp(1, field.bits) - 1;
    return double(word >> field.shift & unsigned(most)) / most;
  }
  case Layout::None:
    break;
  }
  return 0;
}

/// Decodes an sRGB component (OpenGL 2.1, 3.8.15).
double linearOf(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace

Color swizzled(const abi::Swizzle &swizzle, const Color &stored) {
  Color color;
  for (std::size_t i = 0; i < 4; ++i)
    color[i] = swizzle[i] == abi::From::One    ? 1
               : swizzle[i] == abi::From::Zero ? 0
                                               : stored[std::size_t(swizzle[i])];
  return color;
}

Color referenceTexel(const abi::Format &format, const std::uint8_t *bytes) {
  Color stored = {};
  for (int i = 0; i < std::max(abi::componentsOf(format.layout), 1); ++i) {
    const double value = component(format.layout, bytes, i);
    stored[std::size_t(i)] = (format.srgb >> i & 1) == 0 ? value : linearOf(value);
  }
  return swizzled(format.swizzle, stored);
}

} // namespace arbiter::fp::llvm_back::testing
