#include "state/host_draw/draw_needs.h"

#include <algorithm>

#include "state/core/control_hooks.h"
#include "state/host_draw/native_inputs.h"
#include "state/host_draw/texturing/combiner_draw.h"
#include "state/host_draw/texturing/texture_shader_draw.h"
#include "state/objects/linked_program.h"
#include "state/programs/replacement.h"
#include "state/programs/texture_changes.h"
#include "state/programs/variants/alpha_depths.h"
#include "state/programs/variants/point_sprites.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// True if the layer has a part in draws of this path.
bool needsLayer(const DrawContext &context) {
  constexpr Target kOwn[] = {Target::AtiText, Target::AtiApi, Target::Combiners,
                             Target::VertexShader};
  return context.effective.path == Path::HostGlsl || context.effective.path == Path::HostAssembly ||
         isDropped(context.effective.path) ||
         std::any_of(std::begin(kOwn), std::end(kOwn),
                     [&](Target target) { return context.row(target).enabled; });
}

/// For each need of draw_needs.def that lasts a while: true while draws have it.
namespace while_ {
bool State(const DrawContext &context) {
  return nativeInputsMayChange(context) || vertexShaderFollows(context) ||
         (context.effective.linkedProgram && context.effective.linkedProgram->readsState);
}
bool Compare(const DrawContext &context) {
  return context.effective.linkedProgram && context.effective.linkedProgram->hasPlainSamplers &&
         context.caps.samplerObjects &&
         context.group->compareModeUsed.load(std::memory_order_relaxed);
}
bool Invalid(const DrawContext &context) { return isDropped(context.effective.path); }
bool Shared(const DrawContext &context) {
  return context.group->contexts.load(std::memory_order_relaxed) > 1 && needsLayer(context);
}
bool Watch(const DrawContext &context) {
  return context.counters.frames == 0 && !context.passThrough &&
         // A client may also switch a program on again.
         (needsLayer(context) ? replacing() : controlled());
}
bool Software(const DrawContext &context) { return context.softwarePossible; }
bool HostPart(const DrawContext &context) { return context.effective.hostPartWaits; }
bool Depth(const DrawContext &context) {
  return mayFollowAlphaDepths(context) || mayFollowCombinedDepths(context) ||
         mayFollowTextures(context);
}
bool Sprites(const DrawContext &context) { return mayFollowSprites(context); }
} // namespace while_

} // namespace

std::uint32_t lastingNeeds(const DrawContext &context) {
  std::uint32_t bits = 0;
#define STAYS_Once(name)
#define STAYS_Command(name)
#define STAYS_Held(name)
#define STAYS_While(name) bits |= while_::name(context) ? attention::k##name : 0;
#define NEED(name, lasts) STAYS_##lasts(name)
#include "state/core/draw_needs.def"
#undef NEED
  return bits;
}

} // namespace arbiter::state
