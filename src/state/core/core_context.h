#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <GL/gl.h>

#include "fp_compiler/numerics.h"
#include "state/capabilities/host_caps.h"
#include "state/core/context_hot.h"
#include "state/core/draw_needs.h"
#include "state/core/path.h"
#include "state/core/provider.h"
#include "state/objects/capture_effective.h"
#include "state/objects/feedback_tracker.h"
#include "state/objects/list_recorder.h"
#include "util/record/counter.h"

namespace arbiter::state {

class ShareGroup;
struct ContextHooks;
struct EraState;
struct Identity;
struct ImagingState;
struct LinkedProgram;

/// The layer's own errors (2.5). While `pending` is empty, the host is asked.
struct PendingErrors {
  GLenum pending = GL_NO_ERROR;
  GLint position = -1; ///< PROGRAM_ERROR_POSITION_ARB, shared by all targets
  std::string text;    ///< PROGRAM_ERROR_STRING_ARB
};

/// The path that draws take now, and the programs that were chosen for it.
struct DrawChoice {
  Path path = Path::NoProgram;
  LinkedProgram *linkedProgram = nullptr; ///< the current one, or null
  /// GlslHost::alphaDepths that `linkedProgram` was compiled with; nothing if it does not matter.
  std::optional<std::uint32_t> alphaDepths;
  bool hostPartWaits = false;   ///< `linkedProgram` is not built on the host yet (path_choice.h)
  std::uint64_t selections = 0; ///< counts changes of the effective programs
};

/// Figures of the statistics, which any thread may write, and of the window with figures.
struct Counters {
  std::array<Counter, kPathCount> draws{};
  Counter frames;
  Counter readBufferCalls;
  FeedbackTracker feedback;
};

/// A context as the lowest rooms see it: its host, its objects, its errors and its counts.
///
/// A context's state is a staircase of classes. Each adds the state of one floor of rooms, and a
/// room takes the step of its own floor: CoreContext, ProgramContext, DrawContext, RasterContext,
/// and Context, which has all. A function that takes a lower step can be called with a higher one.
/// Every object is a whole Context.
struct CoreContext : ContextHot {
  CoreContext(const CoreContext &) = delete;
  CoreContext &operator=(const CoreContext &) = delete;

  Provider provider = Provider::Glx;
  /// The layer implements the program targets here: a compatibility context with GLSL that was
  /// current once.
  bool offered = false;
  bool rasterizes = true;   ///< the render mode is RENDER
  std::uint32_t serial = 0; ///< its number in statistics

  const ContextHooks *hooks = nullptr; ///< null in the null context alone

  std::shared_ptr<ShareGroup> group;
  HostCaps caps;
  fp::Numerics numerics = fp::Numerics::Host; ///< programs are compiled for these; never changes

  const Identity *identity = nullptr; ///< made at the first query; interned

  PendingErrors errors;

  std::unique_ptr<EraState> era;         ///< null unless the layer offers one of its extensions
  std::unique_ptr<ImagingState> imaging; ///< null unless the layer implements ARB_imaging

  /// The host's real table, while `host` points at the one that defers commands for a recorded
  /// primitive or a list (replay.h).
  const host::HostTable *trueHost = nullptr;
  std::unique_ptr<ListRecorder> list; ///< a ListCompiler
  int listDepth = 0;                  ///< nesting of called lists that hold the layer's commands

  DrawChoice effective;
  CaptureEffective captured; ///< used while there is a capture
  Counters counters;

protected:
  // Only a whole Context is made and destroyed (lifecycle/lifecycle.cpp).
  constexpr CoreContext();
  ~CoreContext();
};

/// True if a command that changes pixels is executed now. Notes in an open list that it changes
/// them when the list is called.
[[nodiscard]] inline bool executesPixels(CoreContext &context) {
  if (context.listMode != 0)
    context.list->notePixels();
  return context.executesNow();
}

/// Makes the next draw choose the effective programs anew.
inline void invalidateProgram(ContextHot &context) {
  // The sticky bits of the old effective program are dropped; selecting sets them anew.
  context.attention = attention::kProgram | (context.attention & attention::kRemains);
}

} // namespace arbiter::state
