#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>

#include "state/objects/program_object.h"

namespace arbiter::state {

/// The programs that shade a draw; null for a stage of fixed function.
struct ProgramPair {
  std::shared_ptr<const CompiledProgram> vertex;
  std::shared_ptr<const CompiledProgram> fragment;
};

/// One stage of a linked program.
struct LinkedProgramStage {
  const CompiledProgram *compiled = nullptr; ///< null: fixed function
  std::vector<GLint> locations; ///< locations of the uniform array's elements; -1: optimized out
  std::vector<Vec4> uploaded;   ///< the values that the host has
  bool readsState = false;      ///< true if it has uniforms of kind State
};

/// A parameter that must be compared before a draw of an assembly program.
struct GivenParameter {
  fp::ir::ParameterKind kind = fp::ir::ParameterKind::Env;
  std::uint32_t index = 0; ///< index of the env or local parameter
  std::uint32_t place = 0; ///< index into GlslShader::uniforms
};

/// A program as an object of the host's own ARB path. Env parameters belong to the target, not to
/// the program; `uploaded` holds those that the last draw read.
struct AssemblyProgram {
  static constexpr std::uint32_t kNoPlace = ~0u;
  GLuint name = 0; ///< 0: the host refused it
  LinkedProgramStage stage;
  /// The parameters that are sent: env and local ones. While draws are captured all others are
  /// listed too; the host reads them itself, but a capture shows them.
  std::vector<GivenParameter> given;
  /// For each local parameter up to the last that is read: its place, or kNoPlace.
  std::vector<std::uint32_t> localPlaces;
  /// additional results that it must write (undefined_results.h)
  std::vector<fp::ir::Output> defined;
  /// true for a fragment program that is better as GLSL (fragment_assembly.h)
  bool changesOften = false;
};

/// A pair of compiled programs as the host runs it, in one context. Contexts do not share it,
/// because a host program holds its uniform values, and contexts of a share group draw on different
/// threads.
///
/// A vertex program is the host's own ARB program where it can be. Passes that compare depths for
/// equality then match as they do without the layer, because no GLSL computes positions exactly
/// like a host's own path. Its fragment program is then linked alone, once for all of its pairs, or
/// is the host's own too (fragment_assembly.h). If the vertex program is GLSL, the two are linked
/// together, or each alone (stagesStandApart()).
struct LinkedProgram {
  bool built = false;     ///< false: the host has nothing of it yet
  bool refused = false;   ///< true if the host refused it
  GLuint hostProgram = 0; ///< the GLSL program; 0: no stage is GLSL, or the host refused it
  /// The GLSL program of the vertex stage, if a pipeline combines it with `hostProgram`
  /// (stage_pipeline.h); else 0.
  GLuint vertexProgram = 0;
  LinkedProgramStage vertex;
  LinkedProgramStage fragment;
  AssemblyProgram *vertexAssembly = nullptr;
  /// May be set beside `vertexAssembly`, or with fixed-function vertices (fragment_assembly.h).
  AssemblyProgram *fragmentAssembly = nullptr;
  std::uint64_t frame = 0; ///< Counters::frames when it was built
  /// the owner of `vertexProgram`; null: itself, or there is none
  LinkedProgram *vertexAlone = nullptr;
  /// The owner of `hostProgram`, if it belongs to another linked program.
  LinkedProgram *fragmentAlone = nullptr;
  bool readsState = false; ///< true if either stage does
  bool hasPlainSamplers = false;

  /// Returns the vertex and the fragment stage that hold what the host was given.
  [[nodiscard]] std::array<LinkedProgramStage *, 2> stages() {
    return {vertexAssembly ? &vertexAssembly->stage
            : vertexAlone  ? &vertexAlone->vertex
                           : &vertex,
            fragmentAssembly ? &fragmentAssembly->stage
            : fragmentAlone  ? &fragmentAlone->fragment
                             : &fragment};
  }
};

} // namespace arbiter::state
