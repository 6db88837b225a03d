#pragma once
#include <cstdint>

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

class Context;
namespace software {
class ImmediateRecorder;
}

/// What every generated entry point reads, and nothing else: it leads the Context so that a
/// passed-on call costs one thread-local load, one test and the host's jump.
struct ContextHot {
  /// The host's functions for this context's provider. Never null: the null context's table holds
  /// the next definition in the process, or a function that does nothing.
  const host::HostTable *host = nullptr;
  /// Non-zero if a draw must call Context::beginDraw first: dirty bits, list compilation, counters
  /// that want each draw. Zero on the hot path.
  std::uint32_t attention = 0;
  /// The host's current program is the layer's; what would observe it restores the
  /// application's first (Context::restoreApplicationProgram).
  bool hostProgramIsOurs = false;
  bool insideBeginEnd = false;
  /// The host's program is a vertex and a fragment program of the layer's, linked: of the vertex
  /// program's results it has only those that the fragment program reads.
  bool stagesAreLinked = false;
  /// 0, GL_COMPILE or GL_COMPILE_AND_EXECUTE.
  std::uint16_t listMode = 0;
  /// A list that the layer keeps is executed as it is compiled: nothing is the rasterizer's.
  bool listIsExecuted = false;
  /// Nothing here is the layer's business (the null context, OpenGL ES, a core profile): the
  /// entries that state owns go to the host as well, without a call into state.
  bool passThrough = false;
  /// The rasterizer of our own is used here (Context::software is not null).
  bool softwarePossible = false;
  /// Some images are shadow-valid alone: what lets the host read pixels has it brought up
  /// to date first (state/residency/residency.h).
  bool hostIsBehind = false;
  /// The rasterizer is used here, or a list is compiled that keeps its primitives for it: what a
  /// command means to the rasterizer is of interest.
  bool softwareListens = false;
  /// An evaluator map of NV_vertex_program was named here once: what evaluates is looked at.
  bool mapsNamed = false;
  /// A command of ARB_imaging was used here, where the layer has it: commands that move pixels ask
  /// for it (state/pixel_commands/pixel_commands.h).
  bool imagesPixels = false;
  /// Generic attributes are the conventional ones here, and not the host's: commands that name them
  /// ask for it (mirror/attribute_aliases.h).
  bool attributesAlias = false;
  /// A primitive is deferred: its vertices go here. Null: to the host.
  software::ImmediateRecorder *recorder = nullptr;
  /// Groups of the host's state that may have changed since we asked for them
  /// (mirror/dirty_bits.h).
  std::uint32_t dirty = ~0u;
  /// The counter of the path that draws take at present (host GLSL, host untouched).
  std::uint64_t *drawCounter = nullptr;
};

} // namespace arbiter::state
