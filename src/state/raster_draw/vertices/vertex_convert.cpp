#include "state/raster_draw/vertices/vertex_convert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include <GL/glext.h>

#include "util/numbers/half.h"

namespace arbiter::state {

namespace {

/// How numbers become floats: unchanged, or as fixed point by one of two rules (OpenGL 1.4, table
/// 2.6; 4.2, 2.3.4).
enum class Rule : std::uint8_t { Plain, Normalized, Symmetric };

struct Half {
  std::uint16_t bits;
};
struct Fixed {
  std::int32_t bits;
};

template <typename T> T load(const std::uint8_t *from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// Converts a fixed-point number of `bits` bits. It divides in doubles, or the largest wide number
/// would not become 1.
template <Rule rule> float fixedPoint(double value, int bits, bool isSigned) {
  const double largest = double((std::uint64_t(1) << (isSigned ? bits - 1 : bits)) - 1);
  if (!isSigned)
    return float(value / largest);
  if constexpr (rule == Rule::Symmetric)
    return float(std::max(value / largest, -1.0));
  return float((2.0 * value + 1.0) / double((std::uint64_t(1) << bits) - 1));
}

/// The fractions of 255 in a table, because a division would be the slowest part of a colour.
constexpr auto kByteFractions = [] {
  std::array<float, 256> fractions{};
  for (std::size_t i = 0; i < fractions.size(); ++i)
    fractions[i] = float(i) / 255.0f;
  return fractions;
}();

template <typename T, Rule rule> float number(T value) {
  if constexpr (std::is_same_v<T, Half>)
    return halfToFloat(value.bits);
  else if constexpr (std::is_same_v<T, Fixed>)
    return float(double(value.bits) / 65536.0);
  else if constexpr (rule == Rule::Plain || std::is_floating_point_v<T>)
    return float(value);
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return kByteFractions[value];
  else if constexpr (sizeof(T) < 4 && rule == Rule::Symmetric)
    return std::max(float(value) / float(std::numeric_limits<T>::max()), -1.0f);
  else if constexpr (sizeof(T) < 4 && std::is_signed_v<T>)
    return (2.0f * float(value) + 1.0f) / float((1 << (8 * sizeof(T))) - 1);
  else if constexpr (sizeof(T) < 4)
    return float(value) / float(std::numeric_limits<T>::max());
  else
    return fixedPoint<rule>(double(value), 8 * sizeof(T), std::is_signed_v<T>);
}

/// Number of elements that vector code converts at a time, for the most common types.
constexpr std::uint32_t kLanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Words = std::uint32_t __attribute__((vector_size(16)));
using Pairs = std::uint64_t __attribute__((vector_size(16)));
static_assert(std::endian::native == std::endian::little);

void store(float *to, const Floats &values) { std::memcpy(to, &values, sizeof values); }

/// The two parts of 1/255, to compute fractions without a division. The first part has so few bits
/// that its products are exact, so only the sum is rounded.
constexpr float kFractionHigh = float(0x8080) / float(1 << 23);
constexpr float kFractionLow = float(1.0 / 255.0 - double(kFractionHigh));
static_assert([] {
  for (int i = 0; i < 256; ++i)
    if (float(i) * kFractionHigh + float(i) * kFractionLow != float(i) / 255.0f)
      return false;
  return true;
}());

/// Stores four colours of bytes, one in each word.
void storeFractions(const Words &words, float *const to[4], std::uint32_t at) {
  using Signed = std::int32_t __attribute__((vector_size(16)));
  for (unsigned c = 0; c < 4; ++c) {
    const auto bytes = (Signed)(words >> (8 * c) & 255u);
    const Floats values = __builtin_convertvector(bytes, Floats);
    store(to[c] + at, values * kFractionHigh + values * kFractionLow);
  }
}

/// Converts elements in vectors, and returns their number.
template <typename T, Rule rule, int components> std::uint32_t convertLanes(const Conversion &job) {
  constexpr bool isBytes =
      std::is_same_v<T, std::uint8_t> && rule != Rule::Plain && components == 4;
  constexpr bool isFloats = std::is_same_v<T, float> && components > 1;
  std::uint32_t i = 0;
  if constexpr (isBytes || isFloats) {
    const std::size_t stride = job.stride;
    const std::uint8_t *from = job.base;
    for (; job.count - i >= kLanes; i += kLanes, from += kLanes * stride) {
      if constexpr (isBytes) {
        storeFractions(Words{load<std::uint32_t>(from), load<std::uint32_t>(from + stride),
                             load<std::uint32_t>(from + 2 * stride),
                             load<std::uint32_t>(from + 3 * stride)},
                       job.to, i);
      } else {
        // Loads two components of four elements as pairs, and splits them into first and second
        // numbers.
        const auto two = [&](const std::uint8_t *at, int c) {
          const auto a = (Floats)Pairs{load<std::uint64_t>(at), load<std::uint64_t>(at + stride)};
          const auto b = (Floats)Pairs{load<std::uint64_t>(at + 2 * stride),
                                       load<std::uint64_t>(at + 3 * stride)};
          store(job.to[c] + i, __builtin_shufflevector(a, b, 0, 2, 4, 6));
          store(job.to[c + 1] + i, __builtin_shufflevector(a, b, 1, 3, 5, 7));
        };
        two(from, 0);
        if constexpr (components == 4)
          two(from + 8, 2);
        if constexpr (components == 3)
          store(job.to[2] + i,
                Floats{load<float>(from + 8), load<float>(from + stride + 8),
                       load<float>(from + 2 * stride + 8), load<float>(from + 3 * stride + 8)});
      }
    }
  }
  return i;
}

template <typename T, Rule rule, int components> void convert(const Conversion &job) {
  float *const x = job.to[0], *const y = job.to[1], *const z = job.to[2], *const w = job.to[3];
  std::uint32_t i = convertLanes<T, rule, components>(job);
  const std::uint8_t *from = job.base + i * job.stride;
  for (; i < job.count; ++i, from += job.stride) {
    x[i] = number<T, rule>(load<T>(from));
    if constexpr (components > 1)
      y[i] = number<T, rule>(load<T>(from + sizeof(T)));
    if constexpr (components > 2)
      z[i] = number<T, rule>(load<T>(from + 2 * sizeof(T)));
    if constexpr (components > 3)
      w[i] = number<T, rule>(load<T>(from + 3 * sizeof(T)));
  }
}

template <Rule rule> void convertBgra(const Conversion &job) {
  Conversion swapped = job;
  std::swap(swapped.to[0], swapped.to[2]);
  convert<std::uint8_t, rule, 4>(swapped);
}

/// Converts INT_2_10_10_10_REV or the unsigned type; x is in the lowest bits.
template <bool isSigned, Rule rule, bool bgra> void convertPacked(const Conversion &job) {
  const std::uint8_t *from = job.base;
  for (std::uint32_t i = 0; i < job.count; ++i, from += job.stride) {
    const auto word = load<std::uint32_t>(from);
    for (int c = 0; c < 4; ++c) {
      const int bits = c == 3 ? 2 : 10;
      const std::uint32_t field = word >> (10 * c) & ((1u << bits) - 1);
      double value = double(field);
      if (isSigned && (field >> (bits - 1)) != 0)
        value -= double(1u << bits);
      float *const to = job.to[bgra && c < 3 ? 2 - c : c];
      to[i] = rule == Rule::Plain ? float(value) : fixedPoint<rule>(value, bits, isSigned);
    }
  }
}

template <typename T, Rule rule> Convert byComponents(int components) {
  constexpr Convert kByCount[] = {convert<T, rule, 1>, convert<T, rule, 2>, convert<T, rule, 3>,
                                  convert<T, rule, 4>};
  return components >= 1 && components <= 4 ? kByCount[components - 1] : nullptr;
}

template <typename T> Convert byRule(const VertexSource::Array &array, bool symmetric) {
  if (!array.normalized)
    return byComponents<T, Rule::Plain>(array.components);
  return symmetric ? byComponents<T, Rule::Symmetric>(array.components)
                   : byComponents<T, Rule::Normalized>(array.components);
}

template <bool isSigned, bool bgra> Convert packedByRule(bool normalized, bool symmetric) {
  if (!normalized)
    return convertPacked<isSigned, Rule::Plain, bgra>;
  return symmetric ? convertPacked<isSigned, Rule::Symmetric, bgra>
                   : convertPacked<isSigned, Rule::Normalized, bgra>;
}

template <bool isSigned> Convert packed(const VertexSource::Array &array, bool symmetric) {
  if (array.components != 4)
    return nullptr;
  return array.bgra ? packedByRule<isSigned, true>(array.normalized, symmetric)
                    : packedByRule<isSigned, false>(array.normalized, symmetric);
}

} // namespace

Convert conversionOf(const VertexSource::Array &array, bool symmetric) {
  switch (array.type) {
  case GL_INT_2_10_10_10_REV:
    return packed<true>(array, symmetric);
  case GL_UNSIGNED_INT_2_10_10_10_REV:
    return packed<false>(array, symmetric);
  default:
    break;
  }
  if (array.bgra) {
    if (array.type != GL_UNSIGNED_BYTE || array.components != 4)
      return nullptr;
    return array.normalized ? convertBgra<Rule::Normalized> : convertBgra<Rule::Plain>;
  }
  switch (array.type) {
  case GL_BYTE:
    return byRule<std::int8_t>(array, symmetric);
  case GL_UNSIGNED_BYTE:
    return byRule<std::uint8_t>(array, symmetric);
  case GL_SHORT:
    return byRule<std::int16_t>(array, symmetric);
  case GL_UNSIGNED_SHORT:
    return byRule<std::uint16_t>(array, symmetric);
  case GL_INT:
    return byRule<std::int32_t>(array, symmetric);
  case GL_UNSIGNED_INT:
    return byRule<std::uint32_t>(array, symmetric);
  case GL_HALF_FLOAT:
    return byComponents<Half, Rule::Plain>(array.components);
  case GL_FLOAT:
    return byComponents<float, Rule::Plain>(array.components);
  case GL_FIXED:
    return byComponents<Fixed, Rule::Plain>(array.components);
  case GL_DOUBLE:
    return byComponents<double, Rule::Plain>(array.components);
  default:
    return nullptr;
  }
}

} // namespace arbiter::state
