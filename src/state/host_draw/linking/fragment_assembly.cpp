#include "state/host_draw/linking/fragment_assembly.h"

#include <algorithm>

#include "fp_compiler/ir/ir.h"
#include "host/host_table.h"
#include "state/core/control_hooks.h"
#include "state/host_draw/draw_context.h"
#include "state/programs/variants/point_sprites.h"
#include "state/report/capture.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using Fragments = LinkedProgramCache::Fragments;

bool isShort(const CompiledProgram &compiled) {
  // in instructions; for longer programs GLSL is the better tested path
  constexpr std::size_t kMax = 256;
  const fp::ir::Program *const program = compiled.program.get();
  return compiled.target == Target::Fragment && program &&
         program->language == fp::ir::Language::ArbFragment && program->code.size() <= kMax;
}

bool isPlainProgram(const CompiledProgram &compiled) {
  if (!isShort(compiled))
    return false;
  fp::ir::Options options = compiled.program->options;
  options.precision = fp::ir::Precision::Unspecified;
  return options == fp::ir::Options();
}

bool readsColors(const CompiledProgram &compiled) {
  const auto &inputs = compiled.program->attributes;
  return std::any_of(inputs.begin(), inputs.end(), [](const fp::ir::Attribute &input) {
    return input.kind == fp::ir::AttributeKind::ColorPrimary ||
           input.kind == fp::ir::AttributeKind::ColorSecondary;
  });
}

/// True while no other context and no client can change the conditions for assembly at any time.
bool mayBeAssembly(const DrawContext &context) {
  const ShareGroup &group = *context.group;
  return context.caps.fragmentProgram && context.numerics == fp::Numerics::Host &&
         !group.compareModeUsed.load(std::memory_order_relaxed) &&
         !group.alphaDepthsUsed.load(std::memory_order_relaxed) && !controlHooks() && !capturing();
}

/// True if new programs may begin as assembly, for their first frame.
bool mayBeginAsAssembly(const DrawContext &context) {
  return context.softwarePossible && context.caps.onProcessor && mayBeAssembly(context);
}

/// True if programs may stay assembly, as long as nothing needs the layer's GLSL.
bool mayStayAssembly(const DrawContext &context) {
  return context.caps.ownFragments && !context.softwarePossible && !mayFollowSprites(context) &&
         spritesAreTheHosts(context) && mayBeAssembly(context);
}

/// True if the program has only options of ARB_fragment_program itself and of ARB_draw_buffers, and
/// writes no depth. Two programs that must compute the same depth must not be compiled by two
/// compilers.
bool isHostsAsItIs(const CompiledProgram &compiled) {
  if (!isShort(compiled) || compiled.replaced() || compiled.glsl.writesDepth)
    return false;
  fp::ir::Options options = compiled.program->options;
  options.precision = fp::ir::Precision::Unspecified;
  options.fog = fp::ir::FogMode::None;
  options.drawBuffers = false;
  return options == fp::ir::Options();
}

bool changesOften(const LinkedProgram *linkedProgram) {
  return linkedProgram && linkedProgram->fragmentAssembly &&
         linkedProgram->fragmentAssembly->changesOften;
}

} // namespace

Fragments fragmentsOf(DrawContext &context, const ProgramPair &pair) {
  if (!pair.fragment)
    return Fragments::Glsl;
  if (mayStayAssembly(context))
    return isHostsAsItIs(*pair.fragment) &&
                   !changesOften(context.hostSide.linkedPrograms->find(pair, Fragments::Assembly))
               ? Fragments::Assembly
               : Fragments::Glsl;
  if (!mayBeginAsAssembly(context) || !isPlainProgram(*pair.fragment))
    return Fragments::Glsl;
  const LinkedProgram *const before =
      context.hostSide.linkedPrograms->find(pair, Fragments::Assembly);
  return before && before->built && before->frame != context.counters.frames ? Fragments::Glsl
                                                                             : Fragments::Assembly;
}

bool assemblyIsOver(DrawContext &context) {
  LinkedProgram &linkedProgram = *context.effective.linkedProgram;
  if (mayStayAssembly(context))
    return changesOften(&linkedProgram);
  if (linkedProgram.frame != context.counters.frames || !mayBeginAsAssembly(context))
    return true;
  GLint model = GL_SMOOTH;
  if (readsColors(*linkedProgram.fragment.compiled))
    context.host->GetIntegerv(GL_SHADE_MODEL, &model);
  if (model != GL_FLAT)
    return false;
  linkedProgram.frame = ~std::uint64_t(0);
  return true;
}

} // namespace arbiter::state
