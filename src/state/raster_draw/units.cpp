#include "state/raster_draw/units.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

using fp::ir::TexTarget;

TextureLevels levelsOf(const SamplerState &state) { return {state.baseLevel, state.maxLevel}; }

/// Returns the stored bytes that sRGB encodes: all but alpha.
std::uint8_t encodedBytes(const abi::Format &format) {
  unsigned bytes = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (format.swizzle[i] <= abi::From::C3)
      bytes |= 1u << int(format.swizzle[i]);
  return std::uint8_t(bytes);
}

/// Converts the border colour to the texture's base format (OpenGL 1.4, 3.8.4). A component that is
/// stored once comes from the first of RGBA that shows it; depth comes from red.
void convertBorder(const abi::Format &format, const float from[4], float to[4]) {
  for (int i = 0; i < 4; ++i) {
    const abi::From source = format.swizzle[std::size_t(i)];
    if (source == abi::From::Zero || source == abi::From::One) {
      to[i] = source == abi::From::One ? 1.0f : 0.0f;
      continue;
    }
    const auto first = std::find(format.swizzle.begin(), format.swizzle.end(), source);
    to[i] = from[abi::isDepth(format.layout) ? 0 : int(first - format.swizzle.begin())];
  }
}

/// Applies TEXTURE_SWIZZLE_RGBA to a format's swizzle, and to the border colour.
void swizzle(const std::array<GLenum, 4> &names, abi::Swizzle &texel, float border[4]) {
  const abi::Swizzle from = texel;
  const std::array<float, 4> color = {border[0], border[1], border[2], border[3]};
  for (std::size_t i = 0; i < 4; ++i) {
    if (names[i] == GL_ZERO || names[i] == GL_ONE) {
      texel[i] = names[i] == GL_ONE ? abi::From::One : abi::From::Zero;
      border[i] = names[i] == GL_ONE ? 1.0f : 0.0f;
      continue;
    }
    const std::size_t component = names[i] - GL_RED; // in the order RED, GREEN, BLUE, ALPHA
    texel[i] = from[component];
    border[i] = color[component];
  }
}

} // namespace

abi::Swizzle depthSwizzle(GLenum mode) {
  using abi::From;
  switch (mode) {
  case GL_INTENSITY:
    return {From::C0, From::C0, From::C0, From::C0};
  case GL_ALPHA:
    return {From::Zero, From::Zero, From::Zero, From::C0};
  case GL_RED:
    return {From::C0, From::Zero, From::Zero, From::One};
  default: // GL_LUMINANCE
    return {From::C0, From::C0, From::C0, From::One};
  }
}

void Units::refresh(RasterContext &context, Mirror &mirror, const Samplers &samplers) {
  m_uses.clear();
  for (const auto &sampler : samplers)
    m_uses.push_back({sampler.unit, fp::jit::dimensionOf(sampler.target)});
  if (mirror.samplersAreDirty(m_uses)) [[unlikely]] {
    releaseSamplers(context);
    mirror.refreshSamplers(m_uses);
  }
}

Outcome Units::judge(RasterContext &context, Mirror &mirror, const Samplers &samplers) {
  refresh(context, mirror, samplers);
  for (const SamplerUse &use : m_uses) {
    const SamplerState &state = mirror.samplers[use.unit][std::size_t(use.dimension)];
    if (state.obstacle ||
        !context.software->residency.samplesTexture(state.texture, use.dimension, levelsOf(state)))
      return Fallback::Texture;
  }
  return {};
}

Outcome Units::bind(RasterContext &context, Mirror &mirror, const Samplers &samplers, Keys &keys) {
  m_bound = 0;
  m_storages.clear();
  m_levelsMatter = 0;
  refresh(context, mirror, samplers);
  for (const auto &sampler : samplers) {
    const abi::Dimension dimension = fp::jit::dimensionOf(sampler.target);
    const SamplerState &state = mirror.samplers[sampler.unit][std::size_t(dimension)];
    if (state.obstacle)
      return Fallback::Texture;
    const char *reason = nullptr;
    const TextureImages *const images = context.software->residency.acquireTexture(
        state.texture, dimension, levelsOf(state), state.key.mip != abi::MipFilter::None, reason);
    if (!images)
      return fallbackNamed(reason, Fallback::Texture);
    abi::SamplerKey &code = keys[sampler.unit];
    code = {};
    abi::TextureView &view = m_views[sampler.unit];
    view = {};
    m_imageCount[sampler.unit] = 0;
    m_bound |= 1u << sampler.unit;
    code.dimension = dimension;
    if (!images->complete)
      continue; // Layout::None samples as (0, 0, 0, 1)
    code = state.key;
    code.dimension = dimension;
    code.format = images->format;
    code.powerOfTwo = images->powerOfTwo;
    code.shadow = isShadow(sampler.target) && state.compares && abi::isDepth(code.format.layout);
    if (abi::isDepth(code.format.layout))
      code.format.swizzle = depthSwizzle(state.depthMode);
    if (images->srgb && state.decodes)
      code.format.srgb = encodedBytes(code.format);
    view = images->view;
    m_imageCount[sampler.unit] = std::uint8_t(images->imageCount);
    m_storages.insert(m_storages.end(), images->storages, images->storages + images->imageCount);
    view.lodBias = state.lodBias;
    view.minLod = state.minLod;
    view.maxLod = state.maxLod;
    view.maxAnisotropy = state.maxAnisotropy;
    convertBorder(code.format, state.borderColor, view.borderColor);
    swizzle(state.swizzle, code.format.swizzle, view.borderColor);
    if (code.mip != abi::MipFilter::None || code.minify != code.magnify)
      m_levelsMatter |= 1u << sampler.unit;
  }
  return {};
}

void Units::settle() const {
  for (const swrast::Storage *const storage : m_storages)
    if (storage->settle(); swrast::DeferredClear *const clear = storage->pendingClear())
      clear->complete();
}

void Units::describe(swrast::ShadingUse &use) const {
  use.imageCount = m_imageCount;
  use.textures = m_storages;
}

void Units::fill(std::array<const abi::TextureView *, abi::kMaxUnits> &textures) const {
  for (std::size_t unit = 0; unit < m_views.size(); ++unit)
    textures[unit] = (m_bound >> unit & 1u) != 0 ? &m_views[unit] : nullptr;
}

} // namespace arbiter::state
