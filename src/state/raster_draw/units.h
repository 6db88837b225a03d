#pragma once
#include <array>
#include <vector>

#include "fp_compiler/jit.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/outcome.h"
#include "swrast/queue/queued_state.h"

namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// The texture that a target samples; a SHADOW target's is the plain one's.
[[nodiscard]] abi::Dimension dimensionOf(fp::ir::TexTarget target);

/// DEPTH_TEXTURE_MODE (ARB_depth_texture): how a depth, or the result of its comparison, becomes
/// RGBA.
[[nodiscard]] abi::Swizzle depthSwizzle(GLenum mode);

/// The textures that a program samples: what its code is compiled for, and what it is
/// called with.
class Units {
public:
  using Samplers = std::vector<fp::jit::Sampler>;
  using Keys = std::array<abi::SamplerKey, abi::kMaxUnits>;
  /// The sampler state of the units comes to be up to date.
  void refresh(Context &context, Mirror &mirror, const Samplers &samplers);
  /// Why the host draws whatever is in the images of the units that are sampled: their sampler
  /// state, or their formats. No pixel is moved.
  [[nodiscard]] Outcome judge(Context &context, Mirror &mirror, const Samplers &samplers);
  /// Looks at the units that are sampled, and has their images ready. Fills their samplers of a
  /// key, which are None before.
  Outcome bind(Context &context, Mirror &mirror, const Samplers &samplers, Keys &keys);
  /// The units that are not sampled are null.
  void fill(std::array<const abi::TextureView *, abi::kMaxUnits> &textures) const;
  /// Draws and clears that wait are done that write what is bound: for functions that sample at
  /// once.
  void settle() const;
  /// What fill() refers to.
  void describe(swrast::ShadingUse &use) const;
  /// Units whose level of detail matters: with mipmaps, or with two filters.
  [[nodiscard]] std::uint32_t levelsMatter() const { return m_levelsMatter; }

private:
  std::vector<SamplerUse> m_uses;
  std::array<abi::TextureView, abi::kMaxUnits> m_views;
  std::array<std::uint8_t, abi::kMaxUnits> m_imageCount{};
  std::vector<swrast::Storage *> m_storages; ///< of all images
  std::uint32_t m_bound = 0;
  std::uint32_t m_levelsMatter = 0;
};

} // namespace arbiter::state::software
