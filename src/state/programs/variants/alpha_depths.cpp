#include "state/programs/variants/alpha_depths.h"

#include "host/host_table.h"
#include "state/core/texture_names.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// True if the unit samples a depth texture with mode ALPHA. Other images may have the mode too,
/// without an effect.
bool readsAlpha(ProgramContext &context, const fp::GlslSampler &sampler) {
  const host::HostTable &host = *context.host;
  const TextureNames image = textureNames(sampler.target);
  host.ActiveTexture(GL_TEXTURE0 + sampler.unit);
  GLint mode = GL_LUMINANCE;
  host.GetTexParameteriv(image.target, GL_DEPTH_TEXTURE_MODE, &mode);
  if (mode != GL_ALPHA)
    return false;
  GLint base = 0;
  GLint depth = 0;
  host.GetTexParameteriv(image.target, GL_TEXTURE_BASE_LEVEL, &base);
  // A query of a level that textures cannot have is an error. Every host has this many.
  constexpr GLint kSafeLevels = 12;
  host.GetTexLevelParameteriv(image.level, base < kSafeLevels ? base : 0, GL_TEXTURE_DEPTH_SIZE,
                              &depth);
  return depth != 0;
}

std::uint32_t unitsOf(ProgramContext &context, const CompiledProgram *vertex,
                      const CompiledProgram *fragment) {
  constexpr unsigned kUnits = 32;
  std::uint32_t units = 0;
  GLint active = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (const CompiledProgram *stage : {vertex, fragment})
    if (stage)
      for (const fp::GlslSampler &sampler : stage->glsl.samplers)
        if (sampler.unit < kUnits && readsAlpha(context, sampler))
          units |= 1u << sampler.unit;
  context.host->ActiveTexture(GLenum(active));
  return units;
}

} // namespace

std::uint32_t alphaDepthsOf(ProgramContext &context, const ProgramPair &pair) {
  return unitsOf(context, pair.vertex.get(), pair.fragment.get());
}

bool mayFollowAlphaDepths(const ProgramContext &context) {
  return context.effective.alphaDepths &&
         context.group->alphaDepthsUsed.load(std::memory_order_relaxed);
}

void followAlphaDepths(ProgramContext &context) {
  const LinkedProgram *const linked = context.effective.linkedProgram;
  if (linked && unitsOf(context, linked->vertex.compiled, linked->fragment.compiled) !=
                    *context.effective.alphaDepths)
    invalidateProgram(context);
}

} // namespace arbiter::state
