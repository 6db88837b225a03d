#include "fp_compiler/back/llvm/testing/pixel_reference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace arbiter::fp::testing {

namespace {
template <typename Number> bool compare(abi::Compare how, Number a, Number b) {
  switch (how) {
  case abi::Compare::Never:
    return false;
  case abi::Compare::Less:
    return a < b;
  case abi::Compare::Equal:
    return a == b;
  case abi::Compare::LessEqual:
    return a <= b;
  case abi::Compare::Greater:
    return a > b;
  case abi::Compare::NotEqual:
    return a != b;
  case abi::Compare::GreaterEqual:
    return a >= b;
  case abi::Compare::Always:
    return true;
  }
  return false;
}

int operated(abi::StencilOp op, int value, int reference) {
  switch (op) {
  case abi::StencilOp::Keep:
    return value;
  case abi::StencilOp::Zero:
    return 0;
  case abi::StencilOp::Replace:
    return reference;
  case abi::StencilOp::Increment:
    return std::min(value + 1, 255);
  case abi::StencilOp::Decrement:
    return std::max(value - 1, 0);
  case abi::StencilOp::Invert:
    return ~value & 255;
  case abi::StencilOp::IncrementWrap:
    return (value + 1) & 255;
  case abi::StencilOp::DecrementWrap:
    return (value - 1) & 255;
  }
  return 0;
}

double factorOf(abi::BlendFactor factor, const std::array<double, 4> &s,
                const std::array<double, 4> &d, const float *constant, std::size_t c) {
  switch (factor) {
  case abi::BlendFactor::Zero:
    return 0;
  case abi::BlendFactor::One:
    return 1;
  case abi::BlendFactor::SourceColor:
    return s[c];
  case abi::BlendFactor::OneMinusSourceColor:
    return 1 - s[c];
  case abi::BlendFactor::DestColor:
    return d[c];
  case abi::BlendFactor::OneMinusDestColor:
    return 1 - d[c];
  case abi::BlendFactor::SourceAlpha:
    return s[3];
  case abi::BlendFactor::OneMinusSourceAlpha:
    return 1 - s[3];
  case abi::BlendFactor::DestAlpha:
    return d[3];
  case abi::BlendFactor::OneMinusDestAlpha:
    return 1 - d[3];
  case abi::BlendFactor::ConstantColor:
    return double(constant[c]);
  case abi::BlendFactor::OneMinusConstantColor:
    return 1 - double(constant[c]);
  case abi::BlendFactor::ConstantAlpha:
    return double(constant[3]);
  case abi::BlendFactor::OneMinusConstantAlpha:
    return 1 - double(constant[3]);
  case abi::BlendFactor::SourceAlphaSaturate:
    return c == 3 ? 1 : std::min(s[3], 1 - d[3]);
  }
  return 0;
}

double equated(abi::BlendEquation equation, double s, double d, double sf, double df) {
  switch (equation) {
  case abi::BlendEquation::Add:
    return s * sf + d * df;
  case abi::BlendEquation::Subtract:
    return s * sf - d * df;
  case abi::BlendEquation::ReverseSubtract:
    return d * df - s * sf;
  case abi::BlendEquation::Min:
    return std::min(s, d);
  case abi::BlendEquation::Max:
    return std::max(s, d);
  }
  return 0;
}

/// Blends bytes as hosts do: operands, factors and each product are rounded to 255ths. The 255ths
/// of v * f are 257 * v * f / 65536, rounded to nearest.
double equatedBytes(abi::BlendEquation equation, double s, double d, double sf, double df) {
  const auto byteOf = [](double value) { return int(std::nearbyint(value * 255)); };
  const auto product = [&](double value, double by) {
    return (byteOf(value) * byteOf(by) * 257 + 32768) >> 16;
  };
  if (equation == abi::BlendEquation::Min || equation == abi::BlendEquation::Max)
    return equated(equation, byteOf(s) / 255.0, d, 1, 1);
  return std::clamp(equated(equation, product(s, sf), product(d, df), 1, 1), 0.0, 255.0) / 255;
}

/// Rounds the operands of a blend to 255ths.
std::array<double, 4> inBytes(const std::array<double, 4> &color) {
  std::array<double, 4> rounded = color;
  for (double &component : rounded)
    component = std::nearbyint(component * 255) / 255;
  return rounded;
}

std::uint32_t logic(abi::LogicOp op, std::uint32_t s, std::uint32_t d) {
  const std::uint32_t results[] = {0,     s & d,  s & ~d,   s,        ~s & d, d,
                                   s ^ d, s | d,  ~(s | d), ~(s ^ d), ~d,     s | ~d,
                                   ~s,    ~s | d, ~(s & d), ~0u};
  return results[int(op)];
}

/// Applies the stencil and depth tests; returns true if the fragment passes.
bool tested(const abi::DepthStencilKey &key, const abi::FragmentData &data, bool back, float depth,
            std::uint32_t &pixel) {
  if (key.layout == abi::Layout::None)
    return true;
  const bool packed = key.layout == abi::Layout::Depth24Stencil8;
  const float z = std::fmin(std::fmax(depth, data.depthMinimum), data.depthMaximum);
  std::uint32_t bits = std::bit_cast<std::uint32_t>(z), old = pixel;
  bool near = true;
  if (key.layout == abi::Layout::Depth32F) {
    near = compare(key.depthCompare, z, std::bit_cast<float>(pixel));
  } else if (key.layout == abi::Layout::Depth32) {
    // The value has 31 bits of the fraction in 32 bits; 1 has all bits set.
    bits = z == 1.0f ? 0xFFFFFFFFu : 2 * std::uint32_t(std::floor(std::ldexp(double(z), 31)));
    near = compare(key.depthCompare, bits, old);
  } else {
    bits = std::uint32_t(std::nearbyint(z * (packed ? 16777215.0f : 65535.0f)));
    old = packed ? pixel >> 8 : pixel;
    near = compare(key.depthCompare, bits, old);
  }
  near |= !key.depthTest;
  const std::size_t side = back;
  const abi::StencilFaceKey &face = back ? key.back : key.front;
  const int stencil = int(pixel & 255), reference = data.stencilReference[side];
  const int mask = data.stencilCompareMask[side];
  const bool tests = packed && key.stencilTest;
  const bool same = !tests || compare(face.compare, reference & mask, stencil & mask);
  if (tests) {
    const int made = operated(!same  ? face.fail
                              : near ? face.depthPass
                                     : face.depthFail,
                              stencil, reference);
    const int writes = data.stencilWriteMask[side];
    pixel = (pixel & ~255u) | std::uint32_t((made & writes) | (stencil & ~writes));
  }
  if (same && near && key.depthTest && key.depthWrite)
    pixel = packed ? bits << 8 | (pixel & 255) : bits;
  return same && near;
}

double component(abi::Layout layout, const std::uint8_t *pixel, int k) {
  const auto at = [&]<typename Number>(Number value) {
    std::memcpy(&value, pixel + std::size_t(k) * sizeof value, sizeof value);
    return value;
  };
  if (abi::isPacked(layout)) {
    std::uint32_t word = 0;
    std::memcpy(&word, pixel, std::size_t(abi::bytesOf(layout)));
    const abi::BitField field = abi::bitsOf(layout, k);
    const unsigned most = (1u << field.bits) - 1;
    return double(word >> field.shift & most) / most;
  }
  if (abi::isHalf(layout)) {
    const std::uint16_t half = at(std::uint16_t());
    const int exponent = half >> 10 & 31, fraction = half & 1023;
    const double size =
        exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return half & 0x8000 ? -size : size;
  }
  if (abi::isFloat(layout))
    return double(at(0.0f));
  if (layout <= abi::Layout::U8x4)
    return pixel[k] / 255.0;
  return at(std::uint16_t()) / 65535.0;
}
} // namespace

std::array<double, 4> readPixel(const abi::Format &format, const std::uint8_t *pixel) {
  std::array<double, 4> rgba = {};
  for (std::size_t c = 0; c < 4; ++c) {
    const abi::From from = format.swizzle[c];
    rgba[c] = from == abi::From::One    ? 1
              : from == abi::From::Zero ? 0
                                        : component(format.layout, pixel, int(from));
  }
  return rgba;
}

ReferencePixel shadeReference(const abi::FragmentKey &key, const abi::FragmentData &data,
                              bool backFacing, const ReferenceFragment &fragment,
                              const std::array<double, 4> &dest, std::uint32_t oldBits,
                              std::uint32_t oldDepthStencil) {
  ReferencePixel result;
  result.color = dest;
  result.bits = oldBits;
  result.depthStencil = oldDepthStencil;
  const abi::Layout layout = key.targets[0].format.layout;
  const bool fixedPoint = !abi::isFloat(layout);
  std::array<double, 4> source = {};
  float constant[4] = {};
  for (std::size_t c = 0; c < 4; ++c) {
    source[c] = key.clampColors || fixedPoint ? std::clamp(double(fragment.color[c]), 0.0, 1.0)
                                              : double(fragment.color[c]);
    constant[c] = fixedPoint ? std::clamp(data.blendColor[c], 0.0f, 1.0f) : data.blendColor[c];
  }
  const float alpha =
      key.clampColors ? std::clamp(fragment.color[3], 0.0f, 1.0f) : fragment.color[3];
  // These are the values that an eight-bit buffer would hold (OpenGL 2.1, 4.1.4).
  const auto compared = [&](float value) {
    return layout == abi::Layout::U8x4 ? std::nearbyint(std::clamp(value, 0.0f, 1.0f) * 255.0f)
                                       : value;
  };
  if (!compare(key.alphaTest, compared(alpha), compared(data.alphaReference)))
    return result;
  result.passed = tested(key.depthStencil, data, backFacing, fragment.depth, result.depthStencil);
  if (!result.passed)
    return result;
  const abi::ColorTargetKey &target = key.targets[0];
  const abi::BlendKey &blend = target.blend;
  const bool bytes = layout == abi::Layout::U8x4;
  if (bytes && blend.enabled) {
    source = inBytes(source);
    for (float &component : constant)
      component = std::nearbyint(component * 255.0f) / 255.0f;
  }
  std::uint32_t packed = 0, kept = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const abi::From at = target.format.swizzle[c];
    bool first = at <= abi::From::C3;
    for (std::size_t before = 0; before < c; ++before)
      first &= target.format.swizzle[before] != at;
    if (!first)
      continue;
    packed |= std::uint32_t(std::nearbyint(std::clamp(fragment.color[c], 0.0f, 1.0f) * 255.0f))
              << (8 * int(at));
    kept |= target.writeMask >> c & 1 ? 0 : 0xFFu << (8 * int(at));
    if (!(target.writeMask >> c & 1))
      continue;
    result.written[c] = true;
    if (blend.enabled && !key.logicOpEnabled)
      result.color[c] = (bytes ? equatedBytes : equated)(
          c == 3 ? blend.alpha : blend.color, source[c], dest[c],
          factorOf(c == 3 ? blend.sourceAlpha : blend.sourceColor, source, dest, constant, c),
          factorOf(c == 3 ? blend.destAlpha : blend.destColor, source, dest, constant, c));
    else
      result.color[c] = source[c];
  }
  if (key.logicOpEnabled)
    result.bits = (logic(key.logicOp, packed, oldBits) & ~kept) | (oldBits & kept);
  return result;
}

} // namespace arbiter::fp::testing
