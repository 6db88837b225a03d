#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>

#include "state/objects/program_object.h"

namespace arbiter::state {

/// The programs that shade a draw, one a stage; null where fixed function does.
struct ProgramPair {
  std::shared_ptr<const CompiledProgram> vertex;
  std::shared_ptr<const CompiledProgram> fragment;
};

/// One stage of a linked program.
struct LinkedProgramStage {
  const CompiledProgram *compiled = nullptr; ///< null: fixed function
  std::vector<GLint> locations;              ///< of the uniform array's elements; -1: dropped
  std::vector<Vec4> uploaded;                ///< what the host holds
  bool readsState = false;                   ///< has uniforms of kind State
};

/// A parameter of a program's, beside what a draw looks at else.
struct GivenParameter {
  fp::ir::ParameterKind kind = fp::ir::ParameterKind::Env;
  std::uint32_t index = 0; ///< of the env or local values
  std::uint32_t place = 0; ///< in GlslShader::uniforms
};

/// A program as an object of the host's own ARB path. Env values are the target's, not the
/// program's: of those `uploaded` holds what the last draw read.
struct AssemblyProgram {
  static constexpr std::uint32_t kNoPlace = ~0u;
  GLuint name = 0; ///< 0: the host refused it
  LinkedProgramStage stage;
  /// Those that the host is given: env and local ones. Where draws are captured the others too,
  /// which are the host's to read, and a capture shows them.
  std::vector<GivenParameter> given;
  /// Of each local parameter up to the last that it reads: the place, or kNoPlace.
  std::vector<std::uint32_t> localPlaces;
  std::vector<fp::ir::Output> defined; ///< beside those that it writes (undefined_results.h)
  bool changesOften = false; ///< a fragment program that is better GLSL (fragment_assembly.h)
};

/// A pair of compiled programs as the host runs it, in one context. Each context has its own
/// because a host program holds its uniform values, and contexts of a share group draw on different
/// threads.
///
/// A vertex program is the host's own ARB program where it can be: passes that compare depths for
/// equality meet only where they do without the layer, and no GLSL computes a position as each
/// host's own path does. Its fragment program is then linked alone, once for all of its pairs, or
/// is the host's own as well (fragment_assembly.h).
/// Where it is GLSL the two are linked to each other, or each alone (stagesStandApart()).
struct LinkedProgram {
  bool built = false;     ///< false: its programs are known, and the host has none of it
  bool refused = false;   ///< by the host
  GLuint hostProgram = 0; ///< of GLSL; 0: neither stage is GLSL, or the host refused it
  /// Of a vertex stage of GLSL that meets its fragment stage, `hostProgram`, in a pipeline
  /// (stage_pipeline.h); else 0.
  GLuint vertexProgram = 0;
  LinkedProgramStage vertex;
  LinkedProgramStage fragment;
  AssemblyProgram *vertexAssembly = nullptr;
  /// Beside `vertexAssembly`, or fixed-function vertices (fragment_assembly.h).
  AssemblyProgram *fragmentAssembly = nullptr;
  std::uint64_t frame = 0;              ///< Context::frames when it was built
  LinkedProgram *vertexAlone = nullptr; ///< whose `vertexProgram` it is; null: its own, or 0
  /// Whose `hostProgram` it is, beside `vertexAssembly` or `vertexProgram`.
  LinkedProgram *fragmentAlone = nullptr;
  bool readsState = false; ///< either stage does
  bool hasPlainSamplers = false;

  /// The stages that hold what the host was given: vertex, fragment.
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
