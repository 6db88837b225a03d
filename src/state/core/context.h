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
#include "state/core/identity.h"
#include "state/core/provider.h"
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

/// Why a draw must be looked at before it goes on (ContextHot::attention).
namespace attention {
inline constexpr std::uint32_t kProgram = 1; ///< what is effective may have changed
// Env or local values may have changed, of the targets whose programs become the host's shader of
// that stage.
inline constexpr std::uint32_t kFragmentParameters = 2;
inline constexpr std::uint32_t kVertexParameters = 4;
inline constexpr std::uint32_t kParameters = kFragmentParameters | kVertexParameters;
inline constexpr std::uint32_t kState = 8;      ///< stays: a program reads GL state
inline constexpr std::uint32_t kCompare = 16;   ///< stays: a plain texture target must not compare
inline constexpr std::uint32_t kInvalid = 32;   ///< stays: draws are errors
inline constexpr std::uint32_t kShared = 64;    ///< stays: another context may load a program
inline constexpr std::uint32_t kList = 128;     ///< stays: a display list is being compiled
inline constexpr std::uint32_t kSoftware = 512; ///< stays: the rasterizer may draw
inline constexpr std::uint32_t kWatch = 256; ///< stays: no frame ends here at which files are seen
/// Stays until validate(): the host has not been given what is effective.
inline constexpr std::uint32_t kHostPart = 1024;
inline constexpr std::uint32_t kDepth = 2048; ///< stays: the texts have a depth mode in them
/// The primitive of a recorder has ended and is not drawn yet (raster_draw/immediate/held.h): every
/// command but Begin and attributes has it drawn first.
inline constexpr std::uint32_t kHeld = 4096;
/// A primitive is recorded (raster_draw/immediate/replay.h): commands that are errors between Begin
/// and End are refused.
inline constexpr std::uint32_t kRecorded = 16384;
/// The host keeps bitmaps that it draws at its next draw (host_draw/kept_letters.h).
inline constexpr std::uint32_t kLetters = 32768;
/// Bits that stay when other programs become effective or are validated.
inline constexpr std::uint32_t kRemains = kList | kLetters;
inline constexpr std::uint32_t kSprites = 8192; ///< stays: points may need a form of their own
} // namespace attention

/// Where a draw goes, with the reason where that is not the layer's. The rows of the statistics.
enum class Path : std::uint8_t {
  HostGlsl,            ///< our translation, on the host
  Rasterizer,          ///< by our own rasterizer
  NoProgram,           ///< host untouched: no program target is enabled
  ApplicationGlsl,     ///< host untouched: the application's own GLSL program wins
  ApplicationPipeline, ///< host untouched: the application's program pipeline wins
  HostAssembly, ///< on the host's ARB path alone, beside fixed function or the application's GLSL
  ApplicationStageGlsl, ///< host untouched: one stage of GLSL, and the host refuses the ARB program
  NotOffered,           ///< host untouched: this context has no program targets of the layer's
  Recorded,             ///< into a display list: counted when compiled
  InvalidProgram,       ///< dropped: the bound program object holds no valid program
  HostRefused,          ///< dropped: the host did not compile or link our shader
};
inline constexpr int kPathCount = 11;
[[nodiscard]] const char *pathName(Path path);

/// One GL context: what the layer keeps about it, and no more. Used by the one thread that it is
/// current on; what other threads may touch is in the ShareGroup.
class Context : public ContextHot {
public:
  struct NullTag {};
  /// The null context: every call passes through it.
  constexpr explicit Context(NullTag);
  Context(Provider contextProvider, const host::HostTable *table,
          std::shared_ptr<ShareGroup> shareGroup);
  ~Context();
  Context(const Context &) = delete;
  Context &operator=(const Context &) = delete;

  Provider provider = Provider::Glx;
  /// We implement the program targets here: a compatibility context with GLSL, made current once.
  bool offered = false;
  bool initialised = false; ///< the host has been asked for its limits
  bool destroyed = false;   ///< free when last un-current
  int currentCount = 0;     ///< guarded by the lifecycle's lock
  std::uint32_t serial = 0; ///< in statistics

  const ContextHooks *hooks = nullptr; ///< null in the null context alone

  std::shared_ptr<ShareGroup> group;
  HostCaps caps;
  fp::Numerics numerics = fp::Numerics::Host; ///< that programs are compiled for; fixed for life

  // --- Errors (2.5): our slot; the host's is asked when it is empty ---
  GLenum pendingError = GL_NO_ERROR;
  GLint errorPosition = -1; ///< PROGRAM_ERROR_POSITION_ARB, shared by all targets
  std::string errorString;  ///< PROGRAM_ERROR_STRING_ARB

  // --- The program targets, by Target ---
  std::array<ProgramTarget, kTargetCount> targets{};
  [[nodiscard]] ProgramTarget &row(Target target) { return targets[std::size_t(target)]; }
  [[nodiscard]] const ProgramTarget &row(Target target) const {
    return targets[std::size_t(target)];
  }
  /// Objects bound lately, by the low bits of their name: binding one again takes no lock.
  std::array<std::shared_ptr<ProgramObject>, 16> recentPrograms;

  std::unique_ptr<NvState> nv; ///< where the profile has NVIDIA's languages, else null

  std::unique_ptr<AttributeAliases> aliases; ///< with `nv`, and where attributes alias; else null

  std::unique_ptr<CombinerState> combiners; ///< where the profile has register combiners, else null
  std::unique_ptr<TextureShaderState> textureShaders; ///< the same of NV_texture_shader
  /// Their texts; null where none is captured or replaced.
  std::unique_ptr<StateTexts> stateTexts;

  std::unique_ptr<VertexShaderState> vertexShaders; ///< where EXT_vertex_shader is the layer's

  std::unique_ptr<EraState> era; ///< where the layer offers one of its extensions, else null

  std::unique_ptr<ImagingState> imaging; ///< where ARB_imaging is the layer's, else null

  // --- ATI fragment shaders ---
  std::unique_ptr<AtiRecorder> atiRecorder; ///< between Begin- and EndFragmentShaderATI

  bool followsFixedFunction = false; ///< draws depend on that state (fixed_function.h)
  /// What is bound, or what it is, may be other than when a draw last asked (texture_changes.h).
  bool texturesChanged = true;

  ClipPlanes clipPlanes; ///< which form vertex programs are drawn in

  // --- The application's GLSL: the host knows; asked again when something may have changed it ---
  GLuint applicationProgram = 0;
  bool applicationProgramKnown = true;
  bool pipelinesUsed = false;

  // --- The path that draws take ---
  Path path = Path::NoProgram;
  LinkedProgram *linkedProgram = nullptr; ///< current, or null
  /// fp::GlslHost::alphaDepths in the texts of `linkedProgram`; empty: they need not have them.
  std::optional<std::uint32_t> alphaDepths;
  bool hostPartWaits = false;   ///< `linkedProgram` is the rasterizer's alone yet (path_choice.h)
  std::uint64_t selections = 0; ///< counts the choices of what is effective
  bool rasterizes = true;       ///< the render mode is RENDER
  bool vertexResultsMatter = false; ///< all of them, while RasterPos is validated
  // Null in the null context alone, as `list` is.
  std::unique_ptr<LinkedProgramCache> linkedPrograms;
  std::unique_ptr<SamplerOverride> samplerOverride;
  std::unique_ptr<HostAssembly> hostAssembly;
  std::unique_ptr<StagePipeline> stagePipeline;

  AttribStack attribStack;
  /// The host's own table while `host` defers it: for a primitive that is recorded, or for a list
  /// (replay.h).
  const host::HostTable *trueHost = nullptr;
  std::unique_ptr<ListRecorder> list; ///< a ListCompiler
  int listDepth = 0;                  ///< nested calls of lists that hold our commands

  CaptureEffective effective; ///< while there is a capture

  /// The rasterizer's part; null where it is not used.
  std::unique_ptr<software::ContextState> software;
  bool softwareRefused = false;                   ///< it was decided: not looked at again
  std::unique_ptr<software::LeftAlone> leftAlone; ///< null: it never was (frames/leave.h)
  software::Drawable drawable;                    ///< as of the last make-current
  software::NeighbourEpoch neighbours;

  // --- Counters ---
  std::array<std::uint64_t, kPathCount> draws{};
  std::uint64_t frames = 0;
  std::uint64_t readBufferCalls = 0;
  FeedbackTracker feedback;

  const Identity *identity = nullptr; ///< made at the first query; interned
};

/// Makes the next draw look at what is effective.
inline void invalidateProgram(Context &context) {
  // Sticky bits of the program that was effective go; selecting sets them anew.
  context.attention = attention::kProgram | (context.attention & attention::kRemains);
}

/// The row of a target's GL name; null where the target is unknown or the host's to answer.
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
  case GL_FRAGMENT_PROGRAM_NV: // one enable and one binding with the ARB's
    row = &context.row(Target::Fragment);
    return context.nv && row->limits.nvOptions != 0 ? row : nullptr;
  default:
    return nullptr;
  }
  return row->offered ? row : nullptr;
}

/// The row that `cap` of Enable names: that of a program target, of ATI_fragment_shader,
/// NV_register_combiners, NV_texture_shader or EXT_vertex_shader.
[[nodiscard]] inline ProgramTarget *enableRowOf(Context &context, GLenum cap) {
  for (const Target target :
       {Target::AtiApi, Target::Combiners, Target::TextureShaders, Target::VertexShader})
    if (cap == infoOf(target).name) {
      ProgramTarget &row = context.row(target);
      return row.offered ? &row : nullptr;
    }
  return rowOf(context, cap);
}

/// The calling thread's context: a static null context before the first make-current, never null.
/// Eight bytes of initial-exec TLS; nothing on the way of a call asks the host which context this
/// is. constinit: without it each access would first call a TLS initialiser.
extern constinit thread_local ContextHot *t_current __attribute__((tls_model("initial-exec")));

} // namespace arbiter::state
