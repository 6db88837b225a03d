#pragma once
#include <cstdint>

#include "util/record/counter.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

class ImmediateRecorder;

/// The members that every generated entry point reads. They come first in Context, so that a
/// passed-on call costs one thread-local load, one test and the host's jump.
struct ContextHot {
  /// The host's functions for this context's provider. Never null: the null context's table calls
  /// the next definition in the process, or a function that does nothing.
  const host::HostTable *host = nullptr;
  /// Why a draw must do more than call the host: bits of core/draw_needs.def. Zero on the fast
  /// path.
  std::uint32_t attention = 0;
  /// The host's current program is the layer's. A command that would expose it restores the
  /// application's program first (handlers::restoreApplicationProgram).
  bool hostProgramIsOurs = false;
  bool insideBeginEnd = false;
  /// The host's program links a vertex and a fragment program of the layer's. It keeps only those
  /// vertex results that the fragment program reads.
  bool stagesAreLinked = false;
  /// 0, GL_COMPILE or GL_COMPILE_AND_EXECUTE.
  std::uint16_t listMode = 0;
  /// The layer executes a list while compiling it (COMPILE_AND_EXECUTE): the rasterizer draws
  /// nothing.
  bool listIsExecuted = false;
  /// The layer has no part in this context (the null context, OpenGL ES, a core profile). Its entry
  /// points go to the host without a call into state.
  bool passThrough = false;
  /// The rasterizer is used here (RasterContext::software is not null).
  bool softwarePossible = false;
  /// Some images are valid in their shadow alone. A command that lets the host read pixels updates
  /// the host first (state/residency/residency.h).
  bool hostIsBehind = false;
  /// Commands must report what they mean to the rasterizer. True if it is used here, or if a list
  /// is compiled that keeps primitives for it.
  bool softwareListens = false;
  /// An evaluator map of NV_vertex_program was named once, so evaluation checks for enabled ones.
  bool mapsNamed = false;
  /// The layer's ARB_imaging was used here, so commands that move pixels check it
  /// (state/pixel_commands/pixel_commands.h).
  bool imagesPixels = false;
  /// The layer makes generic attributes alias conventional ones, so commands that name them check
  /// it (mirror/attribute_aliases.h).
  bool attributesAlias = false;
  /// Receives the vertices of a deferred primitive. Null: they go to the host.
  ImmediateRecorder *recorder = nullptr;
  /// Groups of the host's state that may have changed since they were queried
  /// (mirror/dirty_bits.h).
  std::uint32_t dirty = ~0u;
  /// Counts draws on the current path, when the host draws.
  Counter *drawCounter = nullptr;

  /// True if a command is executed now. False if the host must record it in a list, or refuse it
  /// between Begin and End.
  [[nodiscard]] bool executesNow() const { return !insideBeginEnd && listMode == 0; }
};

/// The calling thread's context. Never null: before the first make-current it is a static null
/// context. It is eight bytes of initial-exec TLS, so no call asks the host which context is
/// current. constinit keeps accesses from calling a TLS initialiser first.
extern constinit thread_local ContextHot *t_current __attribute__((tls_model("initial-exec")));

} // namespace arbiter::state
