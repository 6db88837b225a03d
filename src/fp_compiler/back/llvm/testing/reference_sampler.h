#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/abi.h"

/// Texture sampling as OpenGL 1.4 defines it in 3.8.7 to 3.8.14, one lookup at a time, in doubles
/// and not optimised for speed. Tests compare generated code with it.
namespace arbiter::fp::llvm_back::testing {

using Color = std::array<double, 4>;

struct ReferenceQuery {
  std::array<double, 3> coordinate = {};
  /// Changes of the coordinate for one pixel in x and in y. If `hasDerivatives` is false they are
  /// unused, and the level of detail is 0 before biases.
  std::array<double, 3> dx = {}, dy = {};
  bool hasDerivatives = false;
  double bias = 0;
  double lambdaOffset = 0;     ///< added last, to measure the effect of rounding lambda
  std::optional<double> scale; ///< the scale factor; none: derived from the derivatives
};

/// Returns RGBA from the stored components.
[[nodiscard]] Color swizzled(const abi::Swizzle &swizzle, const Color &stored);
[[nodiscard]] Color referenceTexel(const abi::Format &format, const std::uint8_t *bytes);
/// Returns the lookups that an anisotropic filter averages. It is `query` alone if one is enough or
/// the key has no such filter.
/// \param ratioOffset changes the ratio, to measure the effect of rounding their number
[[nodiscard]] std::vector<ReferenceQuery> referenceSamples(const abi::SamplerKey &key,
                                                           const abi::TextureView &view,
                                                           const ReferenceQuery &query,
                                                           double ratioOffset = 0);
/// Returns one lookup without anisotropy. The scale factor is exact, not one of the approximations
/// that 3.8.8 allows.
[[nodiscard]] Color referenceSample(const abi::SamplerKey &key, const abi::TextureView &view,
                                    const ReferenceQuery &query);

} // namespace arbiter::fp::llvm_back::testing
