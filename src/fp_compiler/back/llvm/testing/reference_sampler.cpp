#include "fp_compiler/back/llvm/testing/reference_sampler.h"

#include <algorithm>
#include <cmath>

namespace arbiter::fp::llvm_back::testing {
namespace {

using abi::Dimension;
using abi::Layout;
using abi::Wrap;

double clampTo(double value, double low, double high) {
  return std::min(std::max(value, low), high);
}

/// Returns the coordinate after the wrap mode, in [0,1] times `size` texels (3.8.7).
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

/// One or two texels in a dimension. -1, and `size` and beyond, are the border.
struct Axis {
  int index[2] = {0, 0};
  double weight[2] = {1, 0};
};

Axis axisOf(Wrap wrap, double s, int size, bool normalized, abi::Filter filter) {
  const double u = wrapped(wrap, s, size, normalized);
  Axis axis;
  if (filter == abi::Filter::Nearest) {
    axis.index[0] = int(std::floor(u));
    // 3.8.8: "if s is 1 the index is w_s - 1", for modes that do not reach the border.
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
  double reference = 0; ///< for a shadow comparison
};

int dimensions(Dimension dimension) {
  return dimension == Dimension::Tex1D ? 1 : dimension == Dimension::Tex3D ? 3 : 2;
}

/// True if the components have 8 bits or less and are not sRGB-encoded.
bool fitsBytes(const abi::Format &format) {
  const bool isBytes = format.layout >= Layout::U8x1 && format.layout <= Layout::U8x4;
  const bool isPacked = abi::isPacked(format.layout) && format.layout != Layout::Bits1010102;
  return (isBytes || isPacked) && format.srgb == 0;
}

/// True if the host filters in byte arithmetic (sample_bytes.cpp).
bool filtersBytes(const abi::SamplerKey &key) {
  bool isSimple = true;
  for (int i = 0; i < dimensions(key.dimension) && key.dimension != Dimension::Cube; ++i)
    isSimple &=
        key.wrap[std::size_t(i)] == Wrap::Repeat || key.wrap[std::size_t(i)] == Wrap::ClampToEdge;
  return fitsBytes(key.format) && isSimple;
}

/// Expands a component of `bits` bits to a byte by repeating its bits.
double repeated(double component, int bits) {
  const auto value = int(std::lround(component * ((1 << bits) - 1)));
  int byte = 0;
  for (int at = 8 - bits; at > -bits; at -= bits)
    byte |= at >= 0 ? value << at : value >> -at;
  return byte / 255.0;
}

/// Returns a texel; a packed one whose components fit bytes is expanded to these.
Color texelOf(const abi::SamplerKey &key, const std::uint8_t *bytes) {
  abi::Format stored = key.format;
  stored.swizzle = abi::kRgba;
  Color color = referenceTexel(stored, bytes);
  if (!abi::isPacked(key.format.layout) || !filtersBytes(key))
    return referenceTexel(key.format, bytes);
  for (int i = 0; i < abi::componentsOf(key.format.layout); ++i)
    color[std::size_t(i)] = repeated(color[std::size_t(i)], abi::bitsOf(key.format.layout, i).bits);
  return swizzled(key.format.swizzle, color);
}

/// Returns a filter's input: a texel or the border colour, or the comparison's result (3.8.14).
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
    color = texelOf(key, level.base + at[2] * level.sliceStride + at[1] * level.rowStride +
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

/// Interpolates between two bytes by a weight in 256ths.
double between(double a, double b, double weight) {
  return std::floor((a * (256 - weight) + b * weight) / 256 + 0.5);
}

/// Returns the texels of a linear filter on bytes.
/// \param s in 256ths of a texel, before half a texel is subtracted
Axis axisOfBytes(Wrap wrap, double s, int size) {
  const auto fixed = std::int64_t(std::nearbyint(s)) - 128;
  const auto floored =
      wrap == Wrap::Repeat ? fixed : std::clamp<std::int64_t>(fixed, 0, 256 * (size - 1));
  const auto first = floored >> 8, weight = floored & 255;
  Axis axis;
  for (int i = 0; i < 2; ++i)
    axis.index[i] = wrap == Wrap::Repeat ? int(((first + i) % size + size) % size)
                                         : int(std::min<std::int64_t>(first + i, size - 1));
  axis.weight[1] = double(weight);
  return axis;
}

/// Samples an image with a linear filter on bytes.
Color sampleBytes(const abi::SamplerKey &key, const abi::TextureView &view, const Place &place) {
  const abi::TextureLevel &level = view.levels[place.image];
  const int size[3] = {level.width, level.height, level.depth};
  const int count = dimensions(key.dimension);
  Axis axes[3];
  for (int i = 0; i < count; ++i) {
    const auto at = std::size_t(i);
    const Wrap wrap = key.dimension == Dimension::Cube ? Wrap::ClampToEdge : key.wrap[at];
    const bool normalized = key.dimension != Dimension::Rect;
    const bool folds = wrap == Wrap::Repeat && !(normalized && (key.powerOfTwo >> i & 1));
    const double s = place.coordinate[at] - (folds ? std::floor(place.coordinate[at]) : 0);
    axes[i] = axisOfBytes(wrap, s * 256 * (normalized ? size[i] : 1), size[i]);
  }
  Color corners[8];
  for (int corner = 0; corner < 1 << count; ++corner) {
    int at[3];
    for (int i = 0; i < 3; ++i)
      at[i] = axes[i].index[corner >> i & 1];
    corners[corner] = texelOrBorder(key, view, level, at, 0);
    for (double &component : corners[corner])
      component = std::round(component * 255);
  }
  for (int i = 0; i < count; ++i)
    for (int corner = 0; corner < 1 << (count - 1 - i); ++corner)
      for (std::size_t c = 0; c < 4; ++c)
        corners[corner][c] =
            between(corners[2 * corner][c], corners[2 * corner + 1][c], axes[i].weight[1]);
  for (double &component : corners[0])
    component /= 255;
  return corners[0];
}

Color sampleImage(const abi::SamplerKey &key, const abi::TextureView &view, const Place &place,
                  abi::Filter filter) {
  if (filter == abi::Filter::Linear && filtersBytes(key))
    return sampleBytes(key, view, place);
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

/// Table 3.21: the major axis of each face, and the axes and signs of its s and t.
struct Face {
  int major, s, t;
  double signS, signT;
};
constexpr Face kFaces[6] = {{0, 2, 1, -1, -1}, {0, 2, 1, 1, -1}, {1, 0, 2, 1, 1},
                            {1, 0, 2, 1, -1},  {2, 0, 1, 1, -1}, {2, 0, 1, -1, -1}};

int faceOf(const std::array<double, 3> &r) {
  const double x = std::fabs(r[0]), y = std::fabs(r[1]), z = std::fabs(r[2]);
  const int major = z >= std::max(x, y) ? 2 : x > y ? 0 : 1;
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

using Way = std::array<double, 3>;

/// Returns a change of the coordinates in texels of the base level.
Way inTexels(const abi::SamplerKey &key, const abi::TextureLevel &base, const ReferenceQuery &query,
             const Way &derivative) {
  const double size[3] = {double(base.width), double(base.height), double(base.depth)};
  Way d = derivative;
  if (key.dimension == Dimension::Cube) {
    // The face's projection is differentiated numerically.
    const int face = faceOf(query.coordinate);
    const double step = 1e-6;
    Way next = query.coordinate, last = query.coordinate;
    for (std::size_t i = 0; i < 3; ++i) {
      next[i] += step * derivative[i];
      last[i] -= step * derivative[i];
    }
    const OnFace a = projected(face, next), b = projected(face, last);
    d = {(a.s - b.s) / (2 * step), (a.t - b.t) / (2 * step), 0};
  }
  Way way = {};
  for (int i = 0; i < dimensions(key.dimension); ++i)
    way[std::size_t(i)] = d[std::size_t(i)] * (key.dimension == Dimension::Rect ? 1 : size[i]);
  return way;
}

double dot(const Way &a, const Way &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns the larger change for one pixel in x or in y, in texels of the base level.
double scaleFactor(const abi::SamplerKey &key, const abi::TextureLevel &base,
                   const ReferenceQuery &query) {
  double rho = 0;
  for (const auto &derivative : {query.dx, query.dy}) {
    const Way way = inTexels(key, base, query, derivative);
    rho = std::max(rho, std::sqrt(dot(way, way)));
  }
  return rho;
}

Color sampleLevel(const abi::SamplerKey &key, const abi::TextureView &view, Place place, int level,
                  abi::Filter filter) {
  if (key.dimension == Dimension::Cube)
    place.image += 6 * level; // the index has the face already
  else
    place.image = level;
  return sampleImage(key, view, place, filter);
}

} // namespace

std::vector<ReferenceQuery> referenceSamples(const abi::SamplerKey &key,
                                             const abi::TextureView &view,
                                             const ReferenceQuery &query, double ratioOffset) {
  if (!key.anisotropic || !query.hasDerivatives || key.format.layout == Layout::None)
    return {query};
  const Way x = inTexels(key, view.levels[0], query, query.dx);
  const Way y = inTexels(key, view.levels[0], query, query.dy);
  // A direction in the window is rotated until its image in the texture is longest.
  const double angle = 0.5 * std::atan2(2 * dot(x, y), dot(x, x) - dot(y, y));
  const auto along = [](const Way &a, const Way &b, double turn) {
    Way way;
    for (std::size_t i = 0; i < 3; ++i)
      way[i] = std::cos(turn) * a[i] + std::sin(turn) * b[i];
    return way;
  };
  const Way longest = along(x, y, angle), shortest = along(x, y, angle + std::acos(-1.0) / 2);
  const double length = std::sqrt(dot(longest, longest));
  const double width =
      std::max(std::sqrt(dot(shortest, shortest)), length / double(view.maxAnisotropy));
  const double ratio = length / std::max(width, 1.0) - 0.125 + ratioOffset;
  const int count = int(clampTo(std::ceil(ratio), 1, abi::kMaxAnisotropy));
  const Way axis = along(query.dx, query.dy, angle);
  std::vector<ReferenceQuery> samples(std::size_t(count), query);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].scale = width;
    for (std::size_t c = 0; c < 3; ++c)
      samples[i].coordinate[c] += ((double(i) + 0.5) / count - 0.5) * axis[c];
  }
  if (key.shadow)
    for (ReferenceQuery &sample : samples)
      sample.coordinate[2] = query.coordinate[2];
  return samples;
}

namespace {
/// Computes the machine code's approximation for the square (sample_parts.h).
double linearLog2(double scale) {
  int exponent = 0;
  const double mantissa = std::frexp(std::max(scale * scale, 0x1p-127), &exponent); // from 1/2 to 1
  return 0.5 * (exponent - 2 + 2 * mantissa);
}
} // namespace

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
  double lambda = 0;
  if (query.scale)
    lambda = std::log2(*query.scale);
  else if (query.hasDerivatives)
    lambda = linearLog2(scaleFactor(key, view.levels[0], query));
  // TXB on a rectangle ignores its bias (ir/semantics.h).
  const double ofProgram = key.dimension == Dimension::Rect ? 0 : query.bias;
  const double bias = ofProgram + (key.hasBias ? double(view.lodBias) : 0);
  lambda += clampTo(bias, -16, 16);
  if (key.hasBias)
    lambda = clampTo(lambda, double(view.minLod), double(view.maxLod));
  lambda += query.lambdaOffset;
  if (lambda <= 0) // for all filters (OpenGL 4.1, 3.9.12)
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
    result[i] = first == second     ? a[i]
                : filtersBytes(key) ? between(std::round(255 * a[i]), std::round(255 * b[i]),
                                              std::floor(256 * fraction)) /
                                          255
                                    : (1 - fraction) * a[i] + fraction * b[i];
  return result;
}

} // namespace arbiter::fp::llvm_back::testing
