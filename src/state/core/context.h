#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/numerics.h"
#include "state/capabilities/host_caps.h"
#include "state/core/attrib_stack.h"
#include "state/core/context_hot.h"
#include "state/core/draw_needs.h"
#include "state/core/path.h"
#include "state/core/provider.h"
#include "state/identity/identity.h"
#include "state/objects/capture_effective.h"
#include "state/objects/clip_plane_use.h"
#include "state/objects/drawable.h"
#include "state/objects/feedback_tracker.h"
#include "state/objects/list_recorder.h"
#include "state/objects/neighbour_epoch.h"
#include "state/objects/program_object.h"
#include "state/objects/target.h"

namespace arbiter::state {

class AtiRecorder;
class CombinerState;
class StateTexts;
struct EraState;
struct ImagingState;
class HostAssembly;
class StagePipeline;
struct AttributeAliases;
class SamplerOverride;
class ShareGroup;
class TextureShaderState;
class LinkedProgramCache;
struct ContextHooks;
struct LinkedProgram;
struct NvState;
struct VertexShaderState;
namespace software {
struct ContextState;
struct LeftAlone;
} // namespace software

/// The layer's own errors (2.5). While `pending` is empty, the host is asked.
struct PendingErrors {
  GLenum pending = GL_NO_ERROR;
  GLint position = -1; ///< PROGRAM_ERROR_POSITION_ARB, shared by all targets
  std::string text;    ///< PROGRAM_ERROR_STRING_ARB
};

/// The application's own GLSL program: cached, and queried again after possible changes.
struct ApplicationProgram {
  GLuint program = 0;
  bool programKnown = true;
  bool pipelinesUsed = false;
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

/// Programs and bindings that the layer holds on the host. All are null only in the null
/// context.
struct HostSide {
  std::unique_ptr<LinkedProgramCache> linkedPrograms;
  std::unique_ptr<SamplerOverride> samplerOverride;
  std::unique_ptr<HostAssembly> assembly;
  std::unique_ptr<StagePipeline> stagePipeline;
};

/// Figures of the statistics and of the window with figures.
struct Counters {
  std::array<std::uint64_t, kPathCount> draws{};
  std::uint64_t frames = 0;
  std::uint64_t readBufferCalls = 0;
  FeedbackTracker feedback;
};

/// From the context's creation to its end (contexts/lifecycle.h).
struct Life {
  bool initialised = false; ///< the host has been asked for its limits
  bool destroyed = false;   ///< to be freed when it is last made un-current
  int currentCount = 0;     ///< guarded by the lifecycle's lock
};

/// The layer's state of one GL context. Only the thread that the context is current on uses it.
/// State that other threads may touch is in the ShareGroup.
class Context : public ContextHot {
public:
  struct NullTag {};
  /// Makes the null context, which passes every call through.
  constexpr explicit Context(NullTag);
  Context(Provider contextProvider, const host::HostTable *table,
          std::shared_ptr<ShareGroup> shareGroup);
  ~Context();
  Context(const Context &) = delete;
  Context &operator=(const Context &) = delete;

  Provider provider = Provider::Glx;
  /// The layer implements the program targets here: a compatibility context with GLSL that was
  /// current once.
  bool offered = false;
  Life life;
  std::uint32_t serial = 0; ///< its number in statistics

  const ContextHooks *hooks = nullptr; ///< null in the null context alone

  std::shared_ptr<ShareGroup> group;
  HostCaps caps;
  fp::Numerics numerics = fp::Numerics::Host; ///< programs are compiled for these; never changes

  PendingErrors errors;

  // --- The program targets, indexed by Target ---
  std::array<ProgramTarget, kTargetCount> targets{};
  [[nodiscard]] ProgramTarget &row(Target target) { return targets[std::size_t(target)]; }
  [[nodiscard]] const ProgramTarget &row(Target target) const {
    return targets[std::size_t(target)];
  }
  /// Recently bound objects, by the low bits of their name: binding one again takes no lock.
  std::array<std::shared_ptr<ProgramObject>, 16> recentPrograms;

  std::unique_ptr<NvState> nv; ///< null unless the profile has NVIDIA's languages

  std::unique_ptr<AttributeAliases> aliases; ///< null unless `nv` is there and attributes alias

  std::unique_ptr<CombinerState> combiners; ///< null unless the profile has register combiners
  std::unique_ptr<TextureShaderState> textureShaders; ///< null unless the profile has
                                                      ///< NV_texture_shader
  /// Program texts of combiner and texture-shader states; null unless some are captured or
  /// replaced.
  std::unique_ptr<StateTexts> stateTexts;

  std::unique_ptr<VertexShaderState> vertexShaders; ///< null unless the layer implements
                                                    ///< EXT_vertex_shader

  std::unique_ptr<EraState> era; ///< null unless the layer offers one of its extensions

  std::unique_ptr<ImagingState> imaging; ///< null unless the layer implements ARB_imaging

  // --- ATI fragment shaders ---
  std::unique_ptr<AtiRecorder> atiRecorder; ///< between Begin- and EndFragmentShaderATI

  bool followsFixedFunction = false; ///< draws depend on fixed-function state (fixed_function.h)
  /// Bound textures, or their contents, may have changed since the last draw (texture_changes.h).
  bool texturesChanged = true;

  ClipPlanes clipPlanes; ///< choose the variant of vertex programs

  ApplicationProgram application;
  DrawChoice effective;
  HostSide hostSide;
  bool rasterizes = true;           ///< the render mode is RENDER
  bool vertexResultsMatter = false; ///< RasterPos is being validated: it needs all results of a
                                    ///< vertex program

  AttribStack attribStack;
  /// The host's real table, while `host` points at the one that defers commands for a recorded
  /// primitive or a list (replay.h).
  const host::HostTable *trueHost = nullptr;
  std::unique_ptr<ListRecorder> list; ///< a ListCompiler
  int listDepth = 0;                  ///< nesting of called lists that hold the layer's commands

  CaptureEffective captured; ///< used while there is a capture

  /// The rasterizer's state; null if the rasterizer is not used here.
  std::unique_ptr<software::ContextState> software;
  bool softwareRefused = false;                   ///< decided for good: no rasterizer here
  std::unique_ptr<software::LeftAlone> leftAlone; ///< null until the context was left to the host
                                                  ///< once (frames/leave.h)
  software::Drawable drawable;                    ///< from the last make-current
  software::NeighbourEpoch neighbours;

  Counters counters;

  const Identity *identity = nullptr; ///< made at the first query; interned
};

/// Makes the next draw choose the effective programs anew.
inline void invalidateProgram(Context &context) {
  // The sticky bits of the old effective program are dropped; selecting sets them anew.
  context.attention = attention::kProgram | (context.attention & attention::kRemains);
}

/// Returns the row of a GL target; null if the target is unknown or not offered.
[[nodiscard]] inline ProgramTarget *rowOf(Context &context, GLenum target) {
  ProgramTarget *row = nullptr;
  switch (target) {
  case infoOf(Target::Fragment).name:
    row = &context.row(Target::Fragment);
    break;
  case infoOf(Target::Vertex).name:
    row = &context.row(Target::Vertex);
    break;
  case infoOf(Target::AtiText).name:
    row = &context.row(Target::AtiText);
    break;
  case GL_FRAGMENT_PROGRAM_NV: // shares its enable and its binding with the ARB's target
    row = &context.row(Target::Fragment);
    return context.nv && row->limits.nvOptions != 0 ? row : nullptr;
  default:
    return nullptr;
  }
  return row->offered ? row : nullptr;
}

/// Returns the row of a capability: a program target's, or that of ATI_fragment_shader,
/// NV_register_combiners, NV_texture_shader or EXT_vertex_shader. Null if there is none.
[[nodiscard]] inline ProgramTarget *enableRowOf(Context &context, GLenum cap) {
  for (const Target target :
       {Target::AtiApi, Target::Combiners, Target::TextureShaders, Target::VertexShader})
    if (cap == infoOf(target).name) {
      ProgramTarget &row = context.row(target);
      return row.offered ? &row : nullptr;
    }
  return rowOf(context, cap);
}

/// The calling thread's context. Never null: before the first make-current it is a static null
/// context. It is eight bytes of initial-exec TLS, so no call asks the host which context is
/// current. constinit keeps accesses from calling a TLS initialiser first.
extern constinit thread_local ContextHot *t_current __attribute__((tls_model("initial-exec")));

} // namespace arbiter::state
