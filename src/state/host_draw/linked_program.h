#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "state/core/target.h"
#include "state/programs/program_object.h"

namespace arbiter::state {

class Context;

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
  std::uint64_t frame = 0; ///< Context::frames when it was built
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

/// The linked programs of a context, with the host's shaders and programs that they consist of.
/// Each program is compiled once, however many it is paired with.
class LinkedProgramCache {
public:
  /// The form of the fragment program on the host. It is GLSL anyway if the host refuses the
  /// assembly, or if the vertex program is GLSL, with which assembly cannot be combined.
  enum class Fragments : std::uint8_t { Glsl, Assembly };
  /// Returns the linked program of `pair`, which must have at least one program. The first call
  /// builds it: the host links it, and compiles what it has not compiled yet. Raises no error.
  [[nodiscard]] LinkedProgram *get(Context &context, const ProgramPair &pair,
                                   Fragments fragments = Fragments::Glsl);
  /// Returns the cache entry of `pair` without building it.
  [[nodiscard]] LinkedProgram *place(Context &context, const ProgramPair &pair,
                                     Fragments fragments = Fragments::Glsl);
  /// Returns the cache entry of `pair`, or null if there is none.
  [[nodiscard]] const LinkedProgram *find(const ProgramPair &pair, Fragments fragments) const;
  /// Returns the program as an object of the host's own ARB path. It is loaded at the first call,
  /// from text that the layer's compiler has checked within its limits. Each has an object of its
  /// own, because a host may crash if one is loaded again and again. Returns null if the host
  /// refuses it. Raises no error.
  /// \param defined additional results that a vertex program must write
  [[nodiscard]] AssemblyProgram *assemblyOf(Context &context,
                                            const std::shared_ptr<const CompiledProgram> &compiled,
                                            const std::vector<fp::ir::Output> &defined = {});
  /// Deletes the host's objects and the linked programs of a compiled program that left its object.
  /// Requires that `context` is current.
  void drop(Context &context, const CompiledProgram *compiled);

  /// Names of host objects, for the context that will delete them.
  struct Names {
    std::vector<GLuint> programs;
    std::vector<GLuint> shaders;
    std::vector<GLuint> assembly; ///< program objects of the host's ARB path
  };
  /// Empties the cache without calling the host.
  [[nodiscard]] Names abandon();
  /// Returns the number of linked programs.
  [[nodiscard]] std::size_t size() const { return m_linkedPrograms.size(); }

private:
  struct Key {
    const CompiledProgram *vertex;
    const CompiledProgram *fragment;
    Fragments fragments;
    bool operator==(const Key &) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key &key) const {
      const std::hash<const void *> hash;
      return (hash(key.vertex) * 31 + hash(key.fragment)) * 2 + std::size_t(key.fragments);
    }
  };
  /// The host's objects of one program. It has both kinds only if it is drawn in both ways.
  struct HostObjects {
    std::shared_ptr<const CompiledProgram> compiled; ///< keeps the linked programs' pointers alive
    std::optional<GLuint> shader;                    ///< 0: the host refused it
    /// one for each `defined`; mostly there is one
    std::vector<std::unique_ptr<AssemblyProgram>> assembly;
  };
  [[nodiscard]] HostObjects &objectsOf(const std::shared_ptr<const CompiledProgram> &compiled);
  [[nodiscard]] GLuint shaderOf(Context &context,
                                const std::shared_ptr<const CompiledProgram> &compiled);
  void build(Context &context, const ProgramPair &pair, Fragments fragments,
             LinkedProgram &linkedProgram);
  [[nodiscard]] bool buildOnAssembly(Context &context, const ProgramPair &pair, Fragments fragments,
                                     LinkedProgram &linkedProgram);
  [[nodiscard]] bool takeFragmentAssembly(Context &context,
                                          const std::shared_ptr<const CompiledProgram> &fragment,
                                          LinkedProgram &linkedProgram);
  [[nodiscard]] bool buildApart(Context &context, const ProgramPair &pair,
                                LinkedProgram &linkedProgram);
  void deleteObjects(Context &context, const HostObjects &objects);
  void sweep(Context &context);

  std::unordered_map<Key, std::unique_ptr<LinkedProgram>, KeyHash> m_linkedPrograms;
  std::unordered_map<const CompiledProgram *, HostObjects> m_objects;
  std::size_t m_sweepAt = 64;
};

/// True if vertex programs are drawn with the host's own ARB path. The host must have one, and
/// numerics must be the host's, because assembly cannot express other numerics.
[[nodiscard]] bool drawsVerticesByAssembly(const Context &context);

/// Updates the host's uniforms of the effective linked program, as far as `attention` says that
/// they may have changed. Requires that its host program is current. It allocates nothing, and
/// makes one call for each run of changed values.
void uploadParameters(Context &context, LinkedProgram &linkedProgram, std::uint32_t attention);
/// Returns a parameter's current value. \param row the effective program's target
[[nodiscard]] Vec4 currentValue(Context &context, const ProgramTarget &row,
                                const fp::ir::Parameter &parameter);
/// Returns the value that the application set for an env or local parameter.
[[nodiscard]] inline Vec4 givenValue(const ProgramTarget &row, bool env, std::size_t index) {
  if (env)
    return index < row.env.size() ? row.env[index] : Vec4{};
  return index < row.bound->locals.size() ? row.bound->locals[index].load() : Vec4{};
}
/// Returns the value of a parameter that is no GL state, while no client of control holds any.
[[nodiscard]] inline Vec4 ownValue(const ProgramTarget &row, const fp::ir::Parameter &parameter) {
  return parameter.kind == fp::ir::ParameterKind::Constant
             ? parameter.constant
             : givenValue(row, parameter.kind == fp::ir::ParameterKind::Env, parameter.index);
}
/// True if all bits are equal. Values would not do: a NaN would be sent every time, and -0 never.
[[nodiscard]] inline bool sameBits(const Vec4 &a, const Vec4 &b) {
  using Halves = std::array<std::uint64_t, 2>;
  return std::bit_cast<Halves>(a) == std::bit_cast<Halves>(b);
}

/// Queries the host for one row of GL state (3.11.3.2).
void fetchState(Context &context, const fp::ir::StateRef &state, GLfloat value[4]);
/// Queries all rows of the matrix that a row of state belongs to, with its modifier applied.
void fetchMatrix(Context &context, const fp::ir::StateRef &state, GLfloat rows[4][4]);

} // namespace arbiter::state
