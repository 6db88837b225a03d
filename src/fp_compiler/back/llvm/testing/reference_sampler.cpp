#include "fp_compiler/back/llvm/testing/reference_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace arbiter::fp::llvm_back::testing {
namespace {

using abi::Dimension;
using abi::Layout;
using abi::Wrap;

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

/// OpenGL 2.1, 3.8.15.
double linearOf(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Color swizzled(const abi::Swizzle &swizzle, const Color &stored) {
  Color color;
  for (std::size_t i = 0; i < 4; ++i)
    color[i] = swizzle[i] == abi::From::One    ? 1
               : swizzle[i] == abi::From::Zero ? 0
                                               : stored[std::size_t(swizzle[i])];
  return color;
}

double clampTo(double value, double low, double high) {
  return std::min(std::max(value, low), high);
}

/// 3.8.7: the coordinate after the wrap mode, in [0,1] times `size` texels.
double wrapped(Wrap wrap, double s, int size, bool normalized) {
  const double n = size, edge = 0.5 / n;
  if (!normalized)
    s /= n;
  switch (wrap) {
  case Wrap::Repeat:
    return n * (s - std::floor(s));
  case Wrap::MirroredRepeat: {
    const double whole = std::floor(s), fraction = s - whole;
    const double mirrored = std::fmod(whole, 2) == 0 ? fraction : 1 - fraction;
    return n * clampTo(mirrored, edge, 1 - edge);
  }
  case Wrap::Clamp:
    return n * clampTo(s, 0, 1);
  case Wrap::ClampToEdge:
    return n * clampTo(s, edge, 1 - edge);
  case Wrap::ClampToBorder:
    return n * clampTo(s, -edge, 1 + edge);
  case Wrap::MirrorClamp:
    return n * clampTo(std::fabs(s), 0, 1);
  case Wrap::MirrorClampToEdge:
    return n * clampTo(std::fabs(s), edge, 1 - edge);
  case Wrap::MirrorClampToBorder:
    return n * clampTo(std::fabs(s), -edge, 1 + edge);
  }
  return 0;
}

/// One or two texels of a dimension; -1 and `size` and beyond are the border.
struct Axis {
  int index[2] = {0, 0};
  double weight[2] = {1, 0};
};

Axis axisOf(Wrap wrap, double s, int size, bool normalized, abi::Filter filter) {
  const double u = wrapped(wrap, s, size, normalized);
  Axis axis;
  if (filter == abi::Filter::Nearest) {
    axis.index[0] = int(std::floor(u));
    // 3.8.8: "if s is 1 the index is w_s - 1", for what does not reach the border.
    if (wrap != Wrap::ClampToBorder && wrap != Wrap::MirrorClampToBorder)
      axis.index[0] = std::min(axis.index[0], size - 1);
    return axis;
  }
  const double whole = std::floor(u - 0.5);
  axis.weight[1] = u - 0.5 - whole;
  axis.weight[0] = 1 - axis.weight[1];
  for (int i = 0; i < 2; ++i) {
    axis.index[i] = int(whole) + i;
    if (wrap == Wrap::Repeat)
      axis.index[i] = (axis.index[i] + size) % size;
  }
  return axis;
}

bool passes(abi::Compare compare, double r, double d) {
  switch (compare) {
  case abi::Compare::Never:
    return false;
  case abi::Compare::Less:
    return r < d;
  case abi::Compare::Equal:
    return r == d;
  case abi::Compare::LessEqual:
    return r <= d;
  case abi::Compare::Greater:
    return r > d;
  case abi::Compare::NotEqual:
    return r != d;
  case abi::Compare::GreaterEqual:
    return r >= d;
  case abi::Compare::Always:
    return true;
  }
  return false;
}

struct Place {
  int image = 0;
  std::array<double, 3> coordinate = {};
  double reference = 0; ///< of a shadow comparison
};

int dimensions(Dimension dimension) {
  return dimension == Dimension::Tex1D ? 1 : dimension == Dimension::Tex3D ? 3 : 2;
}

/// What a filter sees of a texel: the comparison's result where there is one (3.8.14).
Color texelOrBorder(const abi::SamplerKey &key, const abi::TextureView &view,
                    const abi::TextureLevel &level, const int (&at)[3], double reference) {
  const int size[3] = {level.width, level.height, level.depth};
  bool outside = false;
  for (int i = 0; i < dimensions(key.dimension); ++i)
    outside |= at[i] < 0 || at[i] >= size[i];
  Color color;
  if (outside)
    std::copy(std::begin(view.borderColor), std::end(view.borderColor), color.begin());
  else
    color = referenceTexel(key.format, level.base + at[2] * level.sliceStride +
                                           at[1] * level.rowStride +
                                           at[0] * abi::bytesOf(key.format.layout));
  if (!key.shadow)
    return color;
  double depth = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (key.format.swizzle[i] == abi::From::C0)
      depth = color[i];
  if (key.format.layout != Layout::Depth32F)
    reference = clampTo(reference, 0, 1);
  return swizzled(key.format.swizzle, {passes(key.compare, reference, depth) ? 1.0 : 0.0, 0, 0, 0});
}

Color sampleImage(const abi::SamplerKey &key, const abi::TextureView &view, const Place &place,
                  abi::Filter filter) {
  const abi::TextureLevel &level = view.levels[place.image];
  const int size[3] = {level.width, level.height, level.depth};
  Axis axes[3];
  for (int i = 0; i < dimensions(key.dimension); ++i)
    axes[i] =
        axisOf(key.dimension == Dimension::Cube ? Wrap::ClampToEdge : key.wrap[std::size_t(i)],
               place.coordinate[std::size_t(i)], size[i], key.dimension != Dimension::Rect, filter);
  Color sum = {};
  for (int corner = 0; corner < 8; ++corner) {
    int at[3];
    double weight = 1;
    for (int i = 0; i < 3; ++i) {
      at[i] = axes[i].index[corner >> i & 1];
      weight *= axes[i].weight[corner >> i & 1];
    }
    if (weight == 0)
      continue;
    const Color texel = texelOrBorder(key, view, level, at, place.reference);
    for (std::size_t i = 0; i < 4; ++i)
      sum[i] += weight * texel[i];
  }
  return sum;
}

/// Table 3.21. What a face's s and t are made of, signs included, and which axis is the major one.
struct Face {
  int major, s, t;
  double signS, signT;
};
constexpr Face kFaces[6] = {{0, 2, 1, -1, -1}, {0, 2, 1, 1, -1}, {1, 0, 2, 1, 1},
                            {1, 0, 2, 1, -1},  {2, 0, 1, 1, -1}, {2, 0, 1, -1, -1}};

int faceOf(const std::array<double, 3> &r) {
  const double x = std::fabs(r[0]), y = std::fabs(r[1]), z = std::fabs(r[2]);
  const int major = z >= std::max(x, y) ? 2 : x >= y ? 0 : 1;
  return 2 * major + (r[std::size_t(major)] < 0 ? 1 : 0);
}

struct OnFace {
  double s, t;
};
OnFace projected(int face, const std::array<double, 3> &r) {
  const Face &f = kFaces[face];
  const double major = std::fabs(r[std::size_t(f.major)]);
  return {(f.signS * r[std::size_t(f.s)] / major + 1) / 2,
          (f.signT * r[std::size_t(f.t)] / major + 1) / 2};
}

/// How many texels of the base level a pixel in x or in y is, whichever is more.
double scaleFactor(const abi::SamplerKey &key, const abi::TextureLevel &base,
                   const ReferenceQuery &query) {
  const double size[3] = {double(base.width), double(base.height), double(base.depth)};
  double rho = 0;
  for (const auto &derivative : {query.dx, query.dy}) {
    std::array<double, 3> d = derivative;
    if (key.dimension == Dimension::Cube) {
      // The face's projection, differentiated numerically.
      const int face = faceOf(query.coordinate);
      const double step = 1e-6;
      std::array<double, 3> next = query.coordinate, last = query.coordinate;
      for (std::size_t i = 0; i < 3; ++i) {
        next[i] += step * derivative[i];
        last[i] -= step * derivative[i];
      }
      const OnFace a = projected(face, next), b = projected(face, last);
      d = {(a.s - b.s) / (2 * step), (a.t - b.t) / (2 * step), 0};
    }
    double square = 0;
    for (int i = 0; i < dimensions(key.dimension); ++i) {
      const double texels = d[std::size_t(i)] * (key.dimension == Dimension::Rect ? 1 : size[i]);
      square += texels * texels;
    }
    rho = std::max(rho, std::sqrt(square));
  }
  return rho;
}

Color sampleLevel(const abi::SamplerKey &key, const abi::TextureView &view, Place place, int level,
                  abi::Filter filter) {
  if (key.dimension == Dimension::Cube)
    place.image += 6 * level; // the face is there already
  else
    place.image = level;
  return sampleImage(key, view, place, filter);
}

} // namespace

Color referenceTexel(const abi::Format &format, const std::uint8_t *bytes) {
  Color stored = {};
  for (int i = 0; i < std::max(abi::componentsOf(format.layout), 1); ++i) {
    const double value = component(format.layout, bytes, i);
    stored[std::size_t(i)] = (format.srgb >> i & 1) == 0 ? value : linearOf(value);
  }
  return swizzled(format.swizzle, stored);
}

Color referenceSample(const abi::SamplerKey &key, const abi::TextureView &view,
                      const ReferenceQuery &query) {
  if (key.format.layout == Layout::None)
    return {0, 0, 0, 1};
  Place place;
  place.coordinate = query.coordinate;
  place.reference = query.coordinate[2];
  if (key.dimension == Dimension::Cube) {
    place.image = faceOf(query.coordinate);
    const OnFace on = projected(place.image, query.coordinate);
    place.coordinate = {on.s, on.t, 0};
  }
  double lambda = query.hasDerivatives ? std::log2(scaleFactor(key, view.levels[0], query)) : 0;
  // TXB of a rectangle ignores its bias (ir/semantics.h).
  const double ofProgram = key.dimension == Dimension::Rect ? 0 : query.bias;
  const double bias = ofProgram + (key.hasBias ? double(view.lodBias) : 0);
  lambda += clampTo(bias, -16, 16);
  if (key.hasBias)
    lambda = clampTo(lambda, double(view.minLod), double(view.maxLod));
  lambda += query.lambdaOffset;
  const bool late = key.magnify == abi::Filter::Linear && key.minify == abi::Filter::Nearest &&
                    key.mip != abi::MipFilter::None;
  if (lambda <= (late ? 0.5 : 0.0))
    return sampleLevel(key, view, place, 0, key.magnify);
  const int last = view.levelCount - 1;
  if (key.mip == abi::MipFilter::None)
    return sampleLevel(key, view, place, 0, key.minify);
  if (key.mip == abi::MipFilter::Nearest) {
    const int level = lambda <= 0.5 ? 0 : int(clampTo(std::ceil(lambda + 0.5) - 1, 0, last));
    return sampleLevel(key, view, place, level, key.minify);
  }
  const int first = int(clampTo(std::floor(lambda), 0, last));
  const int second = std::min(first + 1, last);
  const double fraction = lambda - std::floor(lambda);
  const Color a = sampleLevel(key, view, place, first, key.minify);
  const Color b = sampleLevel(key, view, place, second, key.minify);
  Color result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = first == second ? a[i] : (1 - fraction) * a[i] + fraction * b[i];
  return result;
}

} // namespace arbiter::fp::llvm_back::testing
