#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/abi.h"

/// Texture sampling as OpenGL 1.4 writes it in 3.8.7 to 3.8.14, one lookup at a time, in doubles
/// and without regard to speed: what generated code is held against.
namespace arbiter::fp::llvm_back::testing {

using Color = std::array<double, 4>;

struct ReferenceQuery {
  std::array<double, 3> coordinate = {};
  /// Of the coordinate, a pixel in x and in y. Unused where `hasDerivatives` is false: then the
  /// level of detail is 0, biases apart.
  std::array<double, 3> dx = {}, dy = {};
  bool hasDerivatives = false;
  double bias = 0;
  double lambdaOffset = 0;     ///< added last: to learn how much a rounding of lambda matters
  std::optional<double> scale; ///< the scale factor; none: of the derivatives
};

/// RGBA of what is stored.
[[nodiscard]] Color swizzled(const abi::Swizzle &swizzle, const Color &stored);
[[nodiscard]] Color referenceTexel(const abi::Format &format, const std::uint8_t *bytes);
/// The lookups whose mean an anisotropic filter gives: `query` itself where there is but one, or
/// where the key asks for none. \param ratioOffset to learn how much a rounding of their number
/// matters
[[nodiscard]] std::vector<ReferenceQuery> referenceSamples(const abi::SamplerKey &key,
                                                           const abi::TextureView &view,
                                                           const ReferenceQuery &query,
                                                           double ratioOffset = 0);
/// One lookup, whatever the key says of anisotropy. The scale factor is the exact one, not one of
/// those that 3.8.8 allows in its place.
[[nodiscard]] Color referenceSample(const abi::SamplerKey &key, const abi::TextureView &view,
                                    const ReferenceQuery &query);

} // namespace arbiter::fp::llvm_back::testing
