#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "swrast/draw_input.h"
#include "swrast/image/storage.h"

/// What draws that wait are drawn with.
namespace arbiter::swrast {

/// What a draw's shading refers to, for who keeps it until later.
struct ShadingUse {
  std::uint32_t parameterRows = 0;                       ///< of FragmentData::parameters
  std::array<std::uint8_t, abi::kMaxUnits> imageCount{}; ///< of each texture: its levels and faces
  std::span<Storage *const> targets;                     ///< that pixels are written to
  std::span<Storage *const> textures;                    ///< that are sampled
  std::shared_ptr<const void> functions;                 ///< keeps the machine code
};

/// A copy of state and shading that draws share as long as nothing changes from one to the next.
class QueuedState {
public:
  QueuedState() = default;
  QueuedState(const QueuedState &) = delete;
  QueuedState &operator=(const QueuedState &) = delete;

  /// Throws std::bad_alloc.
  void set(const RasterState &raster, const Shading &shading, const ShadingUse &use);
  /// Draws with these would be drawn with the same as draws with what was set.
  [[nodiscard]] bool isSame(const RasterState &raster, const Shading &shading,
                            const ShadingUse &use) const;
  /// Nothing is kept alive any more.
  void release() { m_functions.reset(); }

  /// Keeps the machine code.
  [[nodiscard]] std::shared_ptr<const void> functions() const { return m_functions; }
  [[nodiscard]] const RasterState &raster() const { return m_raster; }
  [[nodiscard]] const Shading &shading() const { return m_shading; }

private:
  RasterState m_raster;
  Shading m_shading;
  abi::FragmentData m_data;
  /// As they were given, to be compared: what the copies point at is their own.
  RasterState m_givenRaster;
  Shading m_givenShading;
  abi::FragmentData m_givenData;
  std::array<abi::TextureView, abi::kMaxUnits> m_givenViews;
  std::array<abi::TextureView, abi::kMaxUnits> m_views;
  std::vector<std::array<float, 4>> m_parameters;
  std::vector<abi::TextureLevel> m_levels; ///< of all units, one behind the other
  std::array<std::uint8_t, 128> m_stipple;
  std::shared_ptr<const void> m_functions;
};

} // namespace arbiter::swrast
