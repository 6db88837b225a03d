#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/core/core_context.h"
#include "state/objects/clip_plane_use.h"
#include "state/objects/program_object.h"
#include "state/objects/target.h"

namespace arbiter::state {

class AtiRecorder;
class CombinerState;
class StateTexts;
class TextureShaderState;
struct AttributeAliases;
struct NvState;
struct VertexShaderState;

/// Adds the programs, and the state that is compiled to programs.
struct ProgramContext : CoreContext {
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

  // --- ATI fragment shaders ---
  std::unique_ptr<AtiRecorder> atiRecorder; ///< between Begin- and EndFragmentShaderATI

  bool followsFixedFunction = false; ///< draws depend on fixed-function state (fixed_function.h)
  /// Bound textures, or their contents, may have changed since the last draw (texture_changes.h).
  bool texturesChanged = true;

  ClipPlanes clipPlanes; ///< choose the variant of vertex programs

protected:
  constexpr ProgramContext();
  ~ProgramContext();
};

/// Returns the row of a GL target; null if the target is unknown or not offered.
[[nodiscard]] inline ProgramTarget *rowOf(ProgramContext &context, GLenum target) {
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
[[nodiscard]] inline ProgramTarget *enableRowOf(ProgramContext &context, GLenum cap) {
  for (const Target target :
       {Target::AtiApi, Target::Combiners, Target::TextureShaders, Target::VertexShader})
    if (cap == infoOf(target).name) {
      ProgramTarget &row = context.row(target);
      return row.offered ? &row : nullptr;
    }
  return rowOf(context, cap);
}

/// True if there is the matrix COLOR, of the layer's or of the host's imaging.
[[nodiscard]] inline bool hasColorMatrix(const ProgramContext &context) {
  return context.imaging || context.caps.has("GL_ARB_imaging");
}

} // namespace arbiter::state
