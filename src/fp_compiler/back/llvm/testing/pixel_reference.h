#pragma once
#include "fp_compiler/back/llvm/testing/fragment_scene.h"

/// The operations on one fragment after its program, written from OpenGL 1.4's chapter 4 alone.
/// Tests compare with it.
namespace arbiter::fp::testing {

struct ReferenceFragment {
  std::array<float, 4> color = {};
  float depth = 0;
};
struct ReferencePixel {
  std::array<double, 4> color = {}; ///< as stored components would be read, including kept ones
  std::array<bool, 4> written = {}; ///< by component
  std::uint32_t bits = 0;           ///< with a logic operation: the U8x4 pixel
  std::uint32_t depthStencil = 0;   ///< bits of the depth buffer's pixel
  bool passed = false;
};
/// \param dest RGBA of the previous pixel
/// \param oldBits bits of a U8x4 pixel, for logic operations
[[nodiscard]] ReferencePixel shadeReference(const abi::FragmentKey &key,
                                            const abi::FragmentData &data, bool backFacing,
                                            const ReferenceFragment &fragment,
                                            const std::array<double, 4> &dest,
                                            std::uint32_t oldBits, std::uint32_t oldDepthStencil);

/// Returns RGBA of a colour buffer's pixel.
[[nodiscard]] std::array<double, 4> readPixel(const abi::Format &format, const std::uint8_t *pixel);

} // namespace arbiter::fp::testing
