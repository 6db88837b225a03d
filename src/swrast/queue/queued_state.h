#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "swrast/draw_input.h"
#include "swrast/image/storage.h"

/// The state that queued draws are drawn with.
namespace arbiter::swrast {

/// The objects that a draw's shading refers to, which a queue must copy or keep alive.
struct ShadingUse {
  std::uint32_t parameterRows = 0; ///< number of rows in FragmentData::parameters
  /// number of images of each texture: its levels and faces
  std::array<std::uint8_t, abi::kMaxUnits> imageCount{};
  std::span<Storage *const> targets;     ///< storages that pixels are written to
  std::span<Storage *const> textures;    ///< storages that are sampled
  std::shared_ptr<const void> functions; ///< keeps the machine code alive
};

/// A copy of state and shading, which consecutive draws share while nothing changes.
class QueuedState {
public:
  QueuedState() = default;
  QueuedState(const QueuedState &) = delete;
  QueuedState &operator=(const QueuedState &) = delete;

  /// Copies the state. May throw std::bad_alloc.
  void set(const RasterState &raster, const Shading &shading, const ShadingUse &use);
  /// True if draws with these arguments would be drawn as those with the copied state.
  [[nodiscard]] bool isSame(const RasterState &raster, const Shading &shading,
                            const ShadingUse &use) const;
  /// Lets go of the machine code.
  void release() { m_functions.reset(); }

  /// Returns a reference that keeps the machine code alive.
  [[nodiscard]] std::shared_ptr<const void> functions() const { return m_functions; }
  [[nodiscard]] const RasterState &raster() const { return m_raster; }
  [[nodiscard]] const Shading &shading() const { return m_shading; }

private:
  RasterState m_raster;
  Shading m_shading;
  abi::FragmentData m_data;
  /// The values as given, for comparison; pointers in the copies above point to own memory.
  RasterState m_givenRaster;
  Shading m_givenShading;
  abi::FragmentData m_givenData;
  std::array<abi::TextureView, abi::kMaxUnits> m_givenViews;
  std::array<abi::TextureView, abi::kMaxUnits> m_views;
  std::vector<std::array<float, 4>> m_parameters;
  std::vector<abi::TextureLevel> m_levels; ///< levels of all units, in order
  std::array<std::uint8_t, 128> m_stipple;
  std::shared_ptr<const void> m_functions;
};

} // namespace arbiter::swrast
