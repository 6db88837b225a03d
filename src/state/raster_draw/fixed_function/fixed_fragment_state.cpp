// Queries the host's state that selects a fixed-function fragment program.
#include <algorithm>
#include <iterator>

#include "fp_compiler/ir/ir.h"
#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/unit_scope.h"
#include "state/host_draw/texturing/fixed_function_now.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/fixed_function/fixed_fragment.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/units.h"

namespace arbiter::state {

namespace {

/// The groups of commands that change this state.
constexpr std::uint32_t kGroups = dirty::kTextureBindings | dirty::kTextureParameters |
                                  dirty::kTexGen | dirty::kFog | dirty::kLighting;

/// The values of Combiner::function.
constexpr GLenum kCombineFunctions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                        GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
constexpr int kArguments[] = {1, 2, 2, 2, 3, 2, 2, 2};

/// Queries one half of COMBINE: RGB's or alpha's. The enumerants of the halves differ by one fixed
/// distance.
bool queryCombiner(const host::HostTable &host, bool alpha, Combiner &half) {
  const GLint function = hostEnvironment(host, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB);
  const auto *const row =
      std::find(std::begin(kCombineFunctions), std::end(kCombineFunctions), GLenum(function));
  if (row == std::end(kCombineFunctions))
    return false;
  half.function = std::uint8_t(row - std::begin(kCombineFunctions));
  for (int i = 0; i < kArguments[half.function]; ++i) {
    const GLint source =
        hostEnvironment(host, GLenum(alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + GLenum(i));
    std::uint8_t &to = half.sources[std::size_t(i)];
    if (source == GL_TEXTURE)
      to = 0;
    else if (source == GL_CONSTANT)
      to = 1;
    else if (source == GL_PRIMARY_COLOR)
      to = 2;
    else if (source == GL_PREVIOUS)
      to = 3;
    else if (source >= GL_TEXTURE0 && source < GL_TEXTURE0 + 8)
      to = std::uint8_t(4 + source - GL_TEXTURE0);
    else
      return false;
    const GLint operand =
        hostEnvironment(host, GLenum(alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + GLenum(i));
    half.operands[std::size_t(i)] =
        std::uint8_t(operand == GL_ONE_MINUS_SRC_COLOR || operand == GL_ONE_MINUS_SRC_ALPHA) |
        std::uint8_t((operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA) ? 2 : 0);
  }
  GLfloat scale = 1;
  host.GetTexEnvfv(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, &scale);
  half.scale = std::uint8_t(scale);
  return true;
}

/// Queries the active unit's environment. Returns false for an environment of an extension.
bool queryEnvironment(const host::HostTable &host, TextureUnitKey &unit) {
  switch (hostEnvironment(host, GL_TEXTURE_ENV_MODE)) {
  case GL_REPLACE:
    unit.environment = Environment::Replace;
    return true;
  case GL_MODULATE:
    unit.environment = Environment::Modulate;
    return true;
  case GL_DECAL:
    unit.environment = Environment::Decal;
    return true;
  case GL_BLEND:
    unit.environment = Environment::Blend;
    return true;
  case GL_ADD:
    unit.environment = Environment::Add;
    return true;
  case GL_COMBINE:
    unit.environment = Environment::Combine;
    return queryCombiner(host, false, unit.color) && queryCombiner(host, true, unit.alpha);
  default:
    return false;
  }
}

TexelKind kindOf(const abi::Swizzle &s) {
  using abi::From;
  if (s[3] == From::One)
    return TexelKind::Opaque;
  if (s[0] == From::Zero && s[1] == From::Zero && s[2] == From::Zero)
    return TexelKind::Alpha;
  return s[0] == s[3] ? TexelKind::Intensity : TexelKind::Translucent;
}

/// Changes the target to one whose samples are compared. Returns false if fixed function cannot
/// compare with it (OpenGL 1.4, 3.8.14: TEXTURE_3D and cube maps have no depths).
bool makeShadow(fp::ir::TexTarget &target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
    target = TexTarget::Shadow1D;
    return true;
  case TexTarget::Tex2D:
    target = TexTarget::Shadow2D;
    return true;
  case TexTarget::Rect:
    target = TexTarget::ShadowRect;
    return true;
  default:
    return false;
  }
}

/// True if COMBINE reads a unit without a texture. That is undefined, so the host draws.
bool readsMissing(const FixedFragmentKey &key, const Combiner &half) {
  return std::any_of(half.sources.begin(), half.sources.end(), [&](std::uint8_t source) {
    return source >= 4 && key.units[source - 4u].environment == Environment::Off;
  });
}

} // namespace

Outcome FixedFragments::ask(RasterContext &context) {
  m_state = {};
  const unsigned units = std::min(unsigned(context.caps.maxTextureUnits), 8u);
  const fp::FixedFunction state = fixedFunctionNow(context, (1u << units) - 1u);
  m_state.fog = state.fog;
  m_state.colorSum = state.colorSum;
  for (unsigned unit = 0; unit < units; ++unit) {
    if ((state.disabledUnits >> unit & 1u) != 0)
      continue;
    const UnitScope scope(*context.host, unit);
    m_state.units[unit].target = state.targets[unit];
    if (!queryEnvironment(*context.host, m_state.units[unit]))
      return Fallback::NoFragmentProgram;
  }
  return {};
}

/// Completes the key with what depends on the textures. A unit with an incomplete texture counts as
/// disabled.
Outcome FixedFragments::completeUnits(RasterContext &context, Mirror &mirror,
                                      FixedFragmentKey &key) {
  for (std::size_t i = 0; i < key.units.size(); ++i) {
    TextureUnitKey &unit = key.units[i];
    if (unit.environment == Environment::Off)
      continue;
    const SamplerUse use{std::uint8_t(i), fp::jit::dimensionOf(unit.target)};
    if (mirror.samplersAreDirty({&use, 1})) {
      releaseSamplers(context);
      mirror.refreshSamplers({&use, 1});
    }
    const SamplerState &sampler = mirror.samplers[i][std::size_t(use.dimension)];
    const auto texture = context.software->residency.describeTexture(
        sampler.texture, use.dimension, {sampler.baseLevel, sampler.maxLevel},
        sampler.key.mip != abi::MipFilter::None);
    if (!texture)
      return Fallback::Texture;
    if (!texture->complete) {
      unit = {};
      continue;
    }
    // If components are swizzled, only the host knows what the environment does.
    if (sampler.swizzle != SamplerState{}.swizzle)
      return Fallback::NoFragmentProgram;
    const bool isDepth = abi::isDepth(texture->format.layout);
    if (isDepth && sampler.compares && !makeShadow(unit.target))
      return Fallback::NoFragmentProgram;
    unit.kind = kindOf(isDepth ? depthSwizzle(sampler.depthMode) : texture->format.swizzle);
  }
  for (const TextureUnitKey &unit : key.units)
    if (unit.environment == Environment::Combine &&
        (readsMissing(key, unit.color) || readsMissing(key, unit.alpha)))
      return Fallback::NoFragmentProgram;
  return {};
}

std::shared_ptr<const fp::ir::Program> FixedFragments::get(RasterContext &context, Mirror &mirror,
                                                           Outcome &outcome) {
  if ((mirror.clock.changedSince(m_seen) & kGroups) != 0 || m_seen == 0)
    m_outcome = ask(context);
  m_seen = mirror.clock.now();
  FixedFragmentKey key = m_state;
  outcome = m_outcome;
  if (outcome.ok())
    outcome = completeUnits(context, mirror, key);
  if (!outcome.ok())
    return nullptr;
  return m_programs.get(key, makeFixedFragmentProgram);
}

} // namespace arbiter::state
