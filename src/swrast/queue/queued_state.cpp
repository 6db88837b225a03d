#include "swrast/queue/queued_state.h"

#include <cstring>
#include <type_traits>

#include "util/numbers/same_bits.h"

namespace arbiter::swrast {
namespace {

template <typename T> void copyBytes(T &to, const T &from) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(static_cast<void *>(&to), &from, sizeof to);
}

} // namespace

void QueuedState::set(const RasterState &raster, const Shading &shading, const ShadingUse &use) {
  const abi::FragmentData &data = *shading.data;
  m_parameters.resize(use.parameterRows);
  std::size_t levels = 0;
  for (std::size_t unit = 0; unit < data.textures.size(); ++unit)
    levels += data.textures[unit] ? use.imageCount[unit] : 0u;
  m_levels.resize(levels);

  copyBytes(m_givenRaster, raster);
  copyBytes(m_raster, raster);
  if (raster.polygonStipple) {
    std::memcpy(m_stipple.data(), raster.polygonStipple, m_stipple.size());
    m_raster.polygonStipple = m_stipple.data();
  }
  copyBytes(m_givenShading, shading);
  copyBytes(m_shading, shading);
  copyBytes(m_givenData, data);
  copyBytes(m_data, data);
  m_shading.data = &m_data;
  if (use.parameterRows != 0)
    std::memcpy(m_parameters.data(), data.parameters, use.parameterRows * sizeof m_parameters[0]);
  m_data.parameters = reinterpret_cast<const float(*)[4]>(m_parameters.data());
  abi::TextureLevel *next = m_levels.data();
  for (std::size_t unit = 0; unit < data.textures.size(); ++unit) {
    const abi::TextureView *const view = data.textures[unit];
    if (!view)
      continue;
    copyBytes(m_givenViews[unit], *view);
    copyBytes(m_views[unit], *view);
    const std::size_t count = use.imageCount[unit];
    if (count != 0) {
      std::memcpy(static_cast<void *>(next), view->levels, count * sizeof *next);
      m_views[unit].levels = next;
    }
    m_data.textures[unit] = &m_views[unit];
    next += count;
  }
  m_functions = use.functions;
}

bool QueuedState::isSame(const RasterState &raster, const Shading &shading,
                         const ShadingUse &use) const {
  const abi::FragmentData &data = *shading.data;
  if (!sameBits(raster, m_givenRaster) || !sameBits(shading, m_givenShading) ||
      !sameBits(data, m_givenData) || use.parameterRows != m_parameters.size() ||
      (use.parameterRows != 0 && std::memcmp(m_parameters.data(), data.parameters,
                                             use.parameterRows * sizeof m_parameters[0]) != 0))
    return false;
  if (raster.polygonStipple &&
      std::memcmp(m_stipple.data(), raster.polygonStipple, m_stipple.size()) != 0)
    return false;
  const abi::TextureLevel *next = m_levels.data();
  for (std::size_t unit = 0; unit < data.textures.size(); ++unit) {
    const abi::TextureView *const view = data.textures[unit];
    if (!view)
      continue;
    const std::size_t count = use.imageCount[unit];
    if (!sameBits(*view, m_givenViews[unit]) || next + count > m_levels.data() + m_levels.size() ||
        (count != 0 && std::memcmp(next, view->levels, count * sizeof *next) != 0))
      return false;
    next += count;
  }
  return next == m_levels.data() + m_levels.size();
}

} // namespace arbiter::swrast
