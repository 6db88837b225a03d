// Queries textures with their sampling parameters, from the texture or from a sampler object.
#include <algorithm>
#include <iterator>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

struct DimensionNames {
  GLenum target, binding;
};
/// Indexed by abi::Dimension.
constexpr DimensionNames kDimensions[] = {{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
                                          {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                                          {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                                          {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
                                          {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE}};

bool wrapOf(GLint mode, abi::Wrap &out) {
  switch (mode) {
  case GL_REPEAT:
    out = abi::Wrap::Repeat;
    return true;
  case GL_MIRRORED_REPEAT:
    out = abi::Wrap::MirroredRepeat;
    return true;
  case GL_CLAMP:
    out = abi::Wrap::Clamp;
    return true;
  case GL_CLAMP_TO_EDGE:
    out = abi::Wrap::ClampToEdge;
    return true;
  case GL_CLAMP_TO_BORDER:
    out = abi::Wrap::ClampToBorder;
    return true;
  case GL_MIRROR_CLAMP_EXT:
    out = abi::Wrap::MirrorClamp;
    return true;
  case GL_MIRROR_CLAMP_TO_EDGE:
    out = abi::Wrap::MirrorClampToEdge;
    return true;
  case GL_MIRROR_CLAMP_TO_BORDER_EXT:
    out = abi::Wrap::MirrorClampToBorder;
    return true;
  default:
    return false;
  }
}

void minifyOf(GLint filter, abi::SamplerKey &key) {
  const bool linear = filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST ||
                      filter == GL_LINEAR_MIPMAP_LINEAR;
  key.minify = linear ? abi::Filter::Linear : abi::Filter::Nearest;
  key.mip = abi::MipFilter::None;
  if (filter == GL_NEAREST_MIPMAP_NEAREST || filter == GL_LINEAR_MIPMAP_NEAREST)
    key.mip = abi::MipFilter::Nearest;
  if (filter == GL_NEAREST_MIPMAP_LINEAR || filter == GL_LINEAR_MIPMAP_LINEAR)
    key.mip = abi::MipFilter::Linear;
}

/// Queries sampling parameters: of the texture on the active unit, or of a sampler object.
struct SamplingSource {
  const host::HostTable &host;
  GLenum target;
  GLuint sampler; ///< 0: none
  [[nodiscard]] GLint integer(GLenum pname) const {
    GLint value = 0;
    if (sampler != 0)
      host.GetSamplerParameteriv(sampler, pname, &value);
    else
      host.GetTexParameteriv(target, pname, &value);
    return value;
  }
  void numbers(GLenum pname, GLfloat *values) const {
    if (sampler != 0)
      host.GetSamplerParameterfv(sampler, pname, values);
    else
      host.GetTexParameterfv(target, pname, values);
  }
  [[nodiscard]] GLfloat number(GLenum pname) const {
    GLfloat value = 0;
    numbers(pname, &value);
    return value;
  }
};

/// Returns the limit that the host applies, so that its draws and the rasterizer's look alike.
float anisotropyOf(const HostCaps &caps, float ofTexture) {
  const float most = std::min(caps.maxAnisotropy, float(abi::kMaxAnisotropy));
  if (ofTexture <= 1.0f)
    return 1.0f;
  return caps.limitsAnisotropy ? std::min(ofTexture, most) : most;
}

/// Queries the parameters that a sampler object overrides.
void querySampling(const HostCaps &caps, const SamplingSource &source, SamplerState &state) {
  abi::SamplerKey &key = state.key;
  constexpr GLenum kWraps[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
  // Wrap modes of coordinates that the target lacks stay at their defaults, which makes fewer keys.
  const int coordinates =
      key.dimension == abi::Dimension::Tex1D                                            ? 1
      : key.dimension == abi::Dimension::Tex3D || key.dimension == abi::Dimension::Cube ? 3
                                                                                        : 2;
  for (int i = 0; i < coordinates; ++i)
    if (!wrapOf(source.integer(kWraps[i]), key.wrap[std::size_t(i)]))
      state.obstacle = "a wrap mode";
  key.magnify = source.integer(GL_TEXTURE_MAG_FILTER) == GL_LINEAR ? abi::Filter::Linear
                                                                   : abi::Filter::Nearest;
  minifyOf(source.integer(GL_TEXTURE_MIN_FILTER), key);
  state.minLod = source.number(GL_TEXTURE_MIN_LOD);
  state.maxLod = source.number(GL_TEXTURE_MAX_LOD);
  state.lodBias += source.number(GL_TEXTURE_LOD_BIAS);
  source.numbers(GL_TEXTURE_BORDER_COLOR, state.borderColor);
  state.compares = caps.shadow && source.integer(GL_TEXTURE_COMPARE_MODE) != GL_NONE;
  key.compare = abi::Compare::LessEqual;
  if (state.compares)
    key.compare = abi::Compare(source.integer(GL_TEXTURE_COMPARE_FUNC) - GL_NEVER);
  state.decodes = !caps.srgbDecode || source.integer(GL_TEXTURE_SRGB_DECODE_EXT) == GL_DECODE_EXT;
  if (caps.anisotropy)
    state.maxAnisotropy = anisotropyOf(caps, source.number(GL_TEXTURE_MAX_ANISOTROPY_EXT));
  // A one-dimensional footprint has no longer axis.
  key.anisotropic = state.maxAnisotropy > 1.0f && key.mip != abi::MipFilter::None &&
                    key.dimension != abi::Dimension::Tex1D;
  if (caps.seamlessPerTexture && key.dimension == abi::Dimension::Cube &&
      (key.magnify == abi::Filter::Linear || key.minify == abi::Filter::Linear) &&
      source.integer(GL_TEXTURE_CUBE_MAP_SEAMLESS) != GL_FALSE)
    state.obstacle = "TEXTURE_CUBE_MAP_SEAMLESS";
  if (caps.filterMinmax && source.integer(GL_TEXTURE_REDUCTION_MODE_ARB) != GL_WEIGHTED_AVERAGE_ARB)
    state.obstacle = "TEXTURE_REDUCTION_MODE";
}

/// Queries the parameters that belong to the texture even with a sampler object.
void queryTexture(const HostCaps &caps, const SamplingSource &source, SamplerState &state) {
  state.baseLevel = source.integer(GL_TEXTURE_BASE_LEVEL);
  state.maxLevel = source.integer(GL_TEXTURE_MAX_LEVEL);
  state.depthMode = GLenum(source.integer(GL_DEPTH_TEXTURE_MODE));
  if (!caps.textureSwizzle)
    return;
  GLint swizzle[4] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
  source.host.GetTexParameteriv(source.target, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
  std::copy(std::begin(swizzle), std::end(swizzle), state.swizzle.begin());
}

/// Queries a sampler of the active unit.
void querySampler(const HostCaps &caps, const HostQuery &query, const SamplerUse &use,
                  SamplerState &state) {
  const std::uint64_t seen = state.seen;
  state = {};
  state.seen = seen;
  state.key.dimension = use.dimension;
  const DimensionNames &names = kDimensions[int(use.dimension)];
  if (use.dimension == abi::Dimension::Rect && !caps.textureRectangle) {
    state.obstacle = "no rectangles";
    return;
  }
  state.texture = GLuint(query.integer(names.binding));
  const GLuint sampler = caps.samplerObjects ? GLuint(query.integer(GL_SAMPLER_BINDING)) : 0;
  query.host.GetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &state.lodBias);
  querySampling(caps, {query.host, names.target, sampler}, state);
  queryTexture(caps, {query.host, names.target, 0}, state);
  if (use.dimension == abi::Dimension::Cube && caps.seamlessCube &&
      (state.key.magnify == abi::Filter::Linear || state.key.minify == abi::Filter::Linear) &&
      query.enabled(GL_TEXTURE_CUBE_MAP_SEAMLESS))
    state.obstacle = "TEXTURE_CUBE_MAP_SEAMLESS";
  state.key.hasBias = state.lodBias != 0 || state.minLod != -1000 || state.maxLod != 1000;
}

} // namespace

namespace {
constexpr std::uint32_t kSamplerGroups = dirty::kTextureBindings | dirty::kTextureParameters;
} // namespace

bool Mirror::isDirty(const SamplerUse &use) const {
  const SamplerState &state = samplers[use.unit][std::size_t(use.dimension)];
  return (clock.changedSince(state.seen) & kSamplerGroups) != 0;
}

bool Mirror::samplersAreDirty(std::span<const SamplerUse> uses) const {
  return std::any_of(uses.begin(), uses.end(), [&](const SamplerUse &use) { return isDirty(use); });
}

void Mirror::refreshSamplers(std::span<const SamplerUse> uses) {
  const HostQuery query{m_host};
  const UnitsScope units(m_host);
  for (const SamplerUse &use : uses) {
    if (!isDirty(use))
      continue;
    SamplerState &state = samplers[use.unit][std::size_t(use.dimension)];
    units.select(use.unit);
    querySampler(m_caps, query, use, state);
    state.seen = clock.now();
  }
}

} // namespace arbiter::state
