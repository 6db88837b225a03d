#include "state/lifecycle/lifecycle.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>

#include "host/host_table.h"
#include "host/null_host.h"
#include "state/context/context.h"
#include "state/core/application_identity.h"
#include "state/core/control_hooks.h"
#include "state/core/errors.h"
#include "state/core/garbage.h"
#include "state/core/memory.h"
#include "state/era/era_state.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/kept_letters.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/identity/active_profile.h"
#include "state/imaging/imaging_state.h"
#include "state/lifecycle/context_hooks.h"
#include "state/lifecycle/watching.h"
#include "state/lists/list_compiler.h"
#include "state/mirror/attribute_aliases.h" // its destructor
#include "state/mirror/dirty_bits.h"
#include "state/programs/ati_recorder.h" // its destructor
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h" // its destructor
#include "state/programs/offered_targets.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/programs/replacement.h"
#include "state/programs/state_text.h"
#include "state/programs/texture_changes.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/frames/frame.h"
#include "state/raster_draw/frames/leave.h"
#include "state/raster_draw/immediate/held.h"
#include "state/raster_draw/neighbours.h"
#include "state/report/capture.h"
#include "state/share/share_group.h"
#include "state/statistics/statistics.h"
#include "util/flags.h"
#include "util/log.h"

// Clang 14 does not accept the strings and vectors of libstdc++ 12 as literal types. There a
// constructor makes the null context. It runs before any entry point of this library is called.
#if defined(__clang__) && __clang_major__ < 15
#define ARBITER_CONSTINIT
#define ARBITER_CONSTEXPR
#else
#define ARBITER_CONSTINIT constinit
#define ARBITER_CONSTEXPR constexpr
#endif

namespace arbiter::state {

namespace {

/// Returns the numerics that this host supports of those asked for. Warns once if it supports less.
fp::Numerics numericsOf(const Context &context) {
  const fp::Numerics asked = activeNumerics();
  const fp::Numerics given = fp::numericsOn(glslHost(context.caps), asked);
  static std::atomic<bool> s_said = false;
  if (given != asked && !s_said.exchange(true))
    logWarn("state",
            "numerics %s needs GL_EXT_gpu_shader4 and GL_ARB_shader_bit_encoding, which the "
            "host lacks; going on with %s",
            std::string(nameOf(asked)).c_str(), std::string(nameOf(given)).c_str());
  return given;
}

} // namespace

// The steps of a context, with the types of all their members known.
constexpr CoreContext::CoreContext() = default;
CoreContext::~CoreContext() = default;
constexpr ProgramContext::ProgramContext() = default;
ProgramContext::~ProgramContext() = default;
constexpr DrawContext::DrawContext() = default;
DrawContext::~DrawContext() = default;
constexpr RasterContext::RasterContext() = default;
RasterContext::~RasterContext() = default;

constexpr Context::Context(NullTag) {
  host = &host::kNullHost;
  passThrough = true;
  drawCounter = &counters.draws[int(Path::NotOffered)];
}

namespace {

/// Holds the null context and never destroys it: destructors of other libraries may call entry
/// points.
struct NullHolder {
  union {
    Context context;
  };
  ARBITER_CONSTEXPR NullHolder() : context(Context::NullTag{}) {}
  ARBITER_CONSTEXPR ~NullHolder() {
  } // NOLINT(modernize-use-equals-default): the union's member stays alive
};

ARBITER_CONSTINIT NullHolder g_null;

} // namespace

constinit thread_local ContextHot *t_current __attribute__((tls_model("initial-exec"))) =
    &g_null.context;

Context &nullContext() { return g_null.context; }

Context *currentContext() {
  auto *const context = static_cast<Context *>(t_current);
  return context == &g_null.context ? nullptr : context;
}

Context::Context(Provider contextProvider, const host::HostTable *table,
                 std::shared_ptr<ShareGroup> shareGroup) {
  host = table;
  provider = contextProvider;
  group = std::move(shareGroup);
  hostSide = {std::make_unique<LinkedProgramCache>(), std::make_unique<SamplerOverride>(),
              std::make_unique<HostAssembly>(), std::make_unique<StagePipeline>()};
  list = std::make_unique<ListCompiler>();
  hooks = &kContextHooks;
  passThrough = true; // until it is first current
  drawCounter = &counters.draws[std::size_t(Path::NotOffered)];
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i].target = Target(i);
    targets[i].bound = group->defaultProgram(Target(i));
    targets[i].parameterBits =
        isOfVertices(Target(i)) ? attention::kVertexParameters : attention::kFragmentParameters;
  }
  addNeighbour(*this); // throws without memory, before the group counts this context
  group->contexts.fetch_add(1);
}

Context::~Context() {
  if (!group)
    return;
  removeNeighbour(*this);
  group->contexts.fetch_sub(1);
  try {
    LinkedProgramCache::Names names = hostSide.linkedPrograms->abandon();
    group->addGarbage({std::move(names.programs), std::move(names.shaders),
                       hostSide.samplerOverride->abandon(), std::move(names.assembly)});
  } catch (const std::exception &) { // they stay in the host until the share group is gone
  }
}

namespace {

/// Queries the host's limits and extensions. Called once, while the context is current.
void initialise(Context &context) {
  context.life.initialised = true;
  const HostErrorScope scope(*context.host, context.errors.pending);
  const bool indirect = context.caps.indirect; // the window system has said so
  context.caps = queryHostCaps(*context.host);
  context.caps.indirect = indirect;
  if (!context.caps.compatibility) {
    logInfo("state", "context %u: passed through: %s", context.serial, context.caps.obstacle());
    return;
  }
  if (const char *obstacle = context.caps.obstacle())
    logWarn("state", "context %u: no ARB programs here: %s", context.serial, obstacle);
  context.passThrough = false;
  context.numerics = numericsOf(context);
  context.offered = context.caps.obstacle() == nullptr;
  offerTargets(context);
  context.attribStack.setMaxDepth(std::size_t(context.caps.maxAttribStackDepth));
  context.effective.path = Path::NoProgram;
  context.drawCounter = &context.counters.draws[std::size_t(Path::NoProgram)];
  if (settings().alwaysFixedFunction)
    context.attention |= attention::kProgram; // makes the first draw validate
  if (!settings().extensions.empty())
    static_cast<void>(applicationIdentity(context)); // warns of switched-on extensions that nobody
                                                     // has
}

/// Initialises a context. After a failure the next make-current tries again.
void initialiseWhole(Context &context) {
  try {
    initialise(context);
  } catch (const std::exception &) {
    context.life.initialised = context.offered = false;
    context.passThrough = true;
    throw;
  }
}

/// Guards currentCount and destroyed of all contexts. Only create, destroy and make-current take
/// it.
std::mutex g_lifecycle;

void release(Context *context) {
  bool dead = false;
  {
    const std::lock_guard lock(g_lifecycle);
    dead = context->life.destroyed && context->life.currentCount == 0;
  }
  if (!dead)
    return;
  logFlag(DebugFlag::Contexts, "state", "context %u: freed", context->serial);
  // Each of them may fail for lack of memory, and must not keep the other from forgetting the
  // context.
  const auto despiteFailure = [&](void (*note)(Context &)) {
    try {
      note(*context);
    } catch (const std::exception &) {
    }
  };
  despiteFailure([](Context &gone) { noteContextDestroyed(gone); });
  despiteFailure([](Context &gone) { captureContextGone(gone); });
  delete context;
}

/// Draws a primitive that waits for more (held.h), before the window system sees the pixels.
void drawHeldOf(Context *context) {
  if (context && isHeld(*context))
    drawHeld(*context);
}

} // namespace

Context *createContext(Provider provider, const host::HostTable *table, Context *share,
                       bool indirect) {
  // The new context must find on the host what was finished before it.
  if (share && currentContext() && currentContext()->group == share->group)
    exchange(Exchange::Read, "a context is made that shares");
  auto context = std::make_unique<Context>(provider, table,
                                           share ? share->group : std::make_shared<ShareGroup>());
  if (share) // either may attach depth images by commands of a core profile, which the layer does
             // not see
    context->group->depthImagesUsed.store(true, std::memory_order_relaxed);
  context->caps.indirect = indirect;
  noteContextCreated(*context);
  if (!withinMemory(*context, "capture", [&] { captureContextMade(*context); }))
    context->errors.pending = GL_NO_ERROR; // the context is just not captured; that is no GL error
  logFlag(DebugFlag::Contexts, "state", "context %u: created%s", context->serial,
          share ? ", shared" : "");
  return context.release();
}

void leaveCurrent() {
  Context *const context = currentContext();
  drawHeldOf(context);
  if (context)
    withinMemory(*context, "MakeCurrent", [&] {
      if (context->software)
        context->software->residency.leave();
    });
}

bool exchange(Exchange what, const char *name) {
  Context *const context = currentContext();
  drawHeldOf(context);
  if (!context || !context->softwarePossible || context->insideBeginEnd || context->listMode != 0)
    return false;
  bool isShown = false;
  withinMemory(*context, name, [&] {
    switch (what) {
    case Exchange::Present:
      isShown = presentFrame(*context);
      break;
    case Exchange::Flush:
      context->software->residency.flush(false);
      break;
    case Exchange::Read:
      context->software->residency.synchronise(name);
      break;
    case Exchange::Change:
      context->software->residency.hostDoesAnything(name);
      break;
    }
  });
  return isShown;
}

void hostDefinesLists(std::uint32_t first, std::int32_t count) {
  Context *const context = currentContext();
  drawHeldOf(context);
  if (!context || context->insideBeginEnd || context->listMode != 0 || count <= 0)
    return;
  context->group->listsHoldLetters.store(keepsLetters(*context), std::memory_order_relaxed);
  withinMemory(*context, "NewList", [&] {
    DisplayListTable &lists = context->group->lists;
    if (lists.hasEarly())
      lists.forgetEarly(*context->host, first, GLuint(count));
    for (const GLuint name : lists.namesIn(first, count))
      lists.replace(*context->host, name, nullptr);
  });
}

void hostSwaps() {
  Context *const context = currentContext();
  if (context && context->software)
    context->software->residency.hostSwaps();
}

void makeCurrent(Context *context, const Drawable *drawable) {
  Context *const old = currentContext();
  if (old != context) {
    bool leaves = false;
    {
      const std::lock_guard lock(g_lifecycle);
      if (context)
        ++context->life.currentCount;
      leaves = old && --old->life.currentCount == 0;
    }
    if (leaves) {
      ceasesToBeCurrent(*old);
      withinMemory(*old, "MakeCurrent", [&] { noteProgress(*old); });
    }
    t_current = context ? context : &g_null.context;
    if (context)
      logFlag(DebugFlag::Contexts, "state", "context %u: current", context->serial);
    else
      logFlag(DebugFlag::Contexts, "state", "no context is current");
    if (old)
      release(old);
  } else if (context) {
    ceasesToBeCurrent(*context); // it may get another drawable
  }
  if (context)
    becomesCurrent(*context, drawable ? *drawable : Drawable{});
  if (context && !context->life.initialised) {
    initialiseWhole(*context);
    expect(*context);
    noteProgress(*context);
    beginWatching();
  } else if (context && context->group->hasGarbage() && !context->listMode)
    collectGarbage(*context);
  if (!context)
    return;
  // Contexts that were made since may load programs that are bound here.
  if (context->group->contexts.load(std::memory_order_relaxed) > 1 &&
      (context->attention & attention::kShared) == 0)
    invalidateProgram(*context);
  noteTextureChange(*context);
  if (context->software)
    context->software->residency.enter(context->drawable);
}

void destroyContext(Context *context) {
  {
    const std::lock_guard lock(g_lifecycle);
    context->life.destroyed = true;
  }
  release(context);
}

void copyContext(const Context &from, Context &to, std::uint32_t mask) {
  if (&from == currentContext())
    drawHeldOf(currentContext());
  noteFixedFunctionChange(to);
  to.dirty = dirty::kAll;
  if ((mask & (GL_ENABLE_BIT | GL_TRANSFORM_BIT)) != 0)
    copyClipPlanes(from, to);
  if (from.combiners && to.combiners && (mask & GL_TEXTURE_BIT) != 0) {
    to.combiners->restore(to, std::make_shared<CombinerSettings>(*from.combiners->settings()));
    setEnabled(to, to.row(Target::Combiners), from.row(Target::Combiners).enabled);
  }
  if (from.era && to.era && (mask & GL_POINT_BIT) != 0) {
    to.era->sprites.rMode = from.era->sprites.rMode;
    to.era->sprites.used = to.era->sprites.used || from.era->sprites.used;
    invalidateProgram(to);
  }
  if (from.textureShaders && mayKeepTextures(to)) {
    (void)keepTextures(to);
    if ((mask & GL_TEXTURE_BIT) != 0) {
      to.textureShaders->restore(
          to, std::make_shared<TextureShaderSettings>(*from.textureShaders->settings()));
      setEnabled(to, to.row(Target::TextureShaders), from.row(Target::TextureShaders).enabled);
    }
    if ((mask & GL_PIXEL_MODE_BIT) != 0)
      to.textureShaders->transfers = from.textureShaders->transfers;
  }
  if ((mask & GL_ENABLE_BIT) == 0)
    return;
  to.hostSide.assembly->enablesCopied();
  invalidateProgram(to);
  for (ProgramTarget &row : to.targets)
    setEnabled(to, row, from.row(row.target).enabled);
}

namespace {

/// Drops the early lists: an application that has shown some frames without a program uses none.
void forgetEarlyLists(Context &context) {
  const bool used = context.group->programApiUsed.load(std::memory_order_relaxed);
  if (!used && context.executesNow())
    context.group->lists.forgetEarly(*context.host, 0, UINT32_MAX);
}

} // namespace

void frameEnd(Context *context) {
  if (!context)
    return;
  withinMemory(*context, "SwapBuffers", [&] {
    captureFrame(*context);
    ++context->counters.frames;
    noteTextureChange(*context); // commands that the layer does not see may have changed textures
    if (const ControlHooks *const hooks = controlHooks()) [[unlikely]]
      hooks->frameEnds(*context);
    if (context->counters.frames >= kEarlyFrames && context->group->lists.hasEarly())
      forgetEarlyLists(*context);
    noteProgress(*context);
    leaveOrReturn(*context);
    refreshReplacements(*context);
  });
}

} // namespace arbiter::state
