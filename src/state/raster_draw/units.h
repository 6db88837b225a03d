#pragma once
#include <array>
#include <vector>

#include "fp_compiler/jit.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/outcome.h"
#include "swrast/queue/queued_state.h"

namespace arbiter::state {
struct RasterContext;
}

namespace arbiter::state {

/// Returns how a depth, or the result of its comparison, becomes RGBA (DEPTH_TEXTURE_MODE,
/// ARB_depth_texture).
[[nodiscard]] abi::Swizzle depthSwizzle(GLenum mode);

/// The textures that a program samples: the part of its code's key, and the views it is called
/// with.
class Units {
public:
  using Samplers = std::vector<fp::jit::Sampler>;
  using Keys = std::array<abi::SamplerKey, abi::kMaxUnits>;
  /// Updates the mirror's sampler state of the sampled units.
  void refresh(RasterContext &context, Mirror &mirror, const Samplers &samplers);
  /// Returns why the host must draw, whatever the images contain: because of their sampler state or
  /// formats. Moves no pixel.
  [[nodiscard]] Outcome judge(RasterContext &context, Mirror &mirror, const Samplers &samplers);
  /// Makes the images of the sampled units ready, and fills their samplers in `keys`, which must be
  /// None before.
  Outcome bind(RasterContext &context, Mirror &mirror, const Samplers &samplers, Keys &keys);
  /// Fills the views; units that are not sampled are null.
  void fill(std::array<const abi::TextureView *, abi::kMaxUnits> &textures) const;
  /// Finishes queued draws and clears that write the bound images, for functions that sample at
  /// once.
  void settle() const;
  /// Describes what fill() refers to.
  void describe(swrast::ShadingUse &use) const;
  /// Returns the units whose level of detail matters: they have mipmaps or two filters.
  [[nodiscard]] std::uint32_t levelsMatter() const { return m_levelsMatter; }

private:
  std::vector<SamplerUse> m_uses;
  std::array<abi::TextureView, abi::kMaxUnits> m_views;
  std::array<std::uint8_t, abi::kMaxUnits> m_imageCount{};
  std::vector<swrast::Storage *> m_storages; ///< the storages of all images
  std::uint32_t m_bound = 0;
  std::uint32_t m_levelsMatter = 0;
};

} // namespace arbiter::state
