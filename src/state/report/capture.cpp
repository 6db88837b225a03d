#include "state/report/capture.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>

#include "fp_compiler/compiler.h"
#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"
#include "state/core/unit_scope.h"
#include "state/objects/linked_program.h"
#include "util/exit_lock.h"

namespace arbiter::state {

namespace {

/// The live contexts, so that draws with their effective programs are counted at exit too. Never
/// freed: contexts may be destroyed after static destructors began.
struct Live {
  std::mutex mutex;
  std::vector<CoreContext *> contexts;
};
Live &live() {
  static Live *const s_live = new Live;
  return *s_live;
}

void finishAtExit() {
  Live &l = live();
  const std::unique_lock lock = lockAtExit(l.mutex);
  if (!lock)
    return; // the record of a second ago stays
  for (CoreContext *context : l.contexts)
    captureLeave(*context);
  CaptureRecord::instance()->finish();
}

struct Binding {
  GLenum target;
  GLenum query;
  GLenum level; ///< the target whose level 0 is queried
};

Binding bindingOf(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, GL_TEXTURE_1D};
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    return {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_2D};
  case TexTarget::Tex3D:
    return {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_3D};
  case TexTarget::Cube:
    return {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X};
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, GL_TEXTURE_RECTANGLE};
  }
  return {};
}

TextureUse describeTexture(CoreContext &context, const fp::GlslSampler &sampler) {
  const host::HostTable &host = *context.host;
  const UnitScope unit(host, sampler.unit);
  const Binding binding = bindingOf(sampler.target);
  TextureUse use;
  use.unit = sampler.unit;
  use.target = sampler.target;
  host.GetIntegerv(binding.query, &use.name);
  host.GetTexLevelParameteriv(binding.level, 0, GL_TEXTURE_WIDTH, &use.width);
  host.GetTexLevelParameteriv(binding.level, 0, GL_TEXTURE_HEIGHT, &use.height);
  host.GetTexLevelParameteriv(binding.level, 0, GL_TEXTURE_DEPTH, &use.depth);
  host.GetTexLevelParameteriv(binding.level, 0, GL_TEXTURE_INTERNAL_FORMAT, &use.format);
  if (GLint(sampler.unit) < context.caps.maxTextureUnits) // units above have no fixed function
    for (std::size_t i = 0; i < std::size(kFixedTargets); ++i)
      if (host.IsEnabled(kFixedTargets[i].cap))
        use.enabled |= std::uint8_t(1u << i);
  return use;
}

} // namespace

void captureContextMade(CoreContext &context) {
  if (!capturing())
    return;
  Live &l = live();
  const std::lock_guard lock(l.mutex);
  static const bool s_registered = std::atexit(finishAtExit) == 0;
  static_cast<void>(s_registered);
  l.contexts.push_back(&context);
  CaptureRecord::instance()->contextMade();
}

void captureContextGone(CoreContext &context) {
  if (!capturing())
    return;
  captureLeave(context);
  Live &l = live();
  const std::lock_guard lock(l.mutex);
  std::erase(l.contexts, &context);
}

void captureLoad(const CoreContext &context, const ProgramObject &object, std::string_view text,
                 const fp::CheckResult &result, const CompiledProgram *compiled) {
  if (capturing())
    CaptureRecord::instance()->loaded(context.serial, object.target, text, result,
                                      context.errors.text, compiled);
}

void captureEnter(CoreContext &context) {
  if (!capturing() || !context.effective.linkedProgram)
    return;
  CaptureEffective &effective = context.captured;
  effective.path = std::size_t(context.effective.path);
  effective.hostBefore = context.counters.draws[effective.path];
  effective.rasterizedBefore = context.counters.draws[std::size_t(Path::Rasterizer)];
  const HostErrorScope scope(*context.host, context.errors.pending);
  for (const LinkedProgramStage *const stage : context.effective.linkedProgram->stages()) {
    if (!stage->compiled)
      continue;
    const auto slot = std::size_t(stage->compiled->target);
    effective.programs[slot] = stage->compiled->shared_from_this();
    std::vector<TextureUse> &textures = effective.textures[slot];
    textures.clear();
    for (const fp::GlslSampler &sampler : stage->compiled->glsl.samplers)
      textures.push_back(describeTexture(context, sampler));
  }
}

void captureLeave(CoreContext &context) {
  if (!capturing())
    return;
  CaptureEffective &effective = context.captured;
  const std::uint64_t host = context.counters.draws[effective.path] - effective.hostBefore;
  const std::uint64_t rasterized =
      context.counters.draws[std::size_t(Path::Rasterizer)] - effective.rasterizedBefore;
  for (std::size_t i = 0; i < kTargetCount; ++i) {
    const std::shared_ptr<const CompiledProgram> program = std::move(effective.programs[i]);
    if (!program || host + rasterized == 0)
      continue;
    const std::vector<Vec4> *held = nullptr;
    if (LinkedProgram *const linkedProgram = context.effective.linkedProgram)
      for (const LinkedProgramStage *const stage : linkedProgram->stages())
        if (stage->compiled == program.get())
          held = &stage->uploaded;
    CaptureRecord::instance()->used(
        {Target(i),
         program,
         context.serial,
         context.counters.frames,
         {{{pathName(Path(effective.path)), host}, {pathName(Path::Rasterizer), rasterized}}},
         held,
         &effective.textures[i]});
  }
}

void captureFrame(CoreContext &context) {
  if (!capturing())
    return;
  captureLeave(context);
  // Makes the next draw look at the effective programs and their textures again.
  if (!context.passThrough)
    context.attention |= attention::kProgram;
  CaptureRecord::instance()->frameEnded();
}

} // namespace arbiter::state
