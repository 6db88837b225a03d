#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "state/objects/target.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

class Context;

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

/// The linked programs of a context, and the host's shaders and programs that they are made of:
/// each program is compiled once, however many it is paired with.
class LinkedProgramCache {
public:
  /// What the host has of the fragment program; GLSL where it refuses it as assembly, or has the
  /// vertex program as GLSL, which assembly does not meet.
  enum class Fragments : std::uint8_t { Glsl, Assembly };
  /// The linked program of `pair`, of which one program at least is not null; built at the first
  /// call, in which case the host links, and compiles what it has not compiled yet. Raises no
  /// error.
  [[nodiscard]] LinkedProgram *get(Context &context, const ProgramPair &pair,
                                   Fragments fragments = Fragments::Glsl);
  /// The same, which the host is not asked for: it may not be built yet.
  [[nodiscard]] LinkedProgram *place(Context &context, const ProgramPair &pair,
                                     Fragments fragments = Fragments::Glsl);
  /// The same, if there is one; else null.
  [[nodiscard]] const LinkedProgram *find(const ProgramPair &pair, Fragments fragments) const;
  /// The program as the host's own ARB path has it, from the text of what our compiler checked,
  /// within our limits; loaded at the first call. Each in an object of its own, for a host may not
  /// survive one that is specified again and again. Null if the host refuses it. Raises no error.
  /// \param defined results of a vertex program that are to be, beside those that it writes
  [[nodiscard]] AssemblyProgram *assemblyOf(Context &context,
                                            const std::shared_ptr<const CompiledProgram> &compiled,
                                            const std::vector<fp::ir::Output> &defined = {});
  /// Deletes the host's objects and the linked programs of a compiled program that left its object.
  /// `context` is current.
  void drop(Context &context, const CompiledProgram *compiled);

  /// Host objects, for the context that deletes them.
  struct Names {
    std::vector<GLuint> programs;
    std::vector<GLuint> shaders;
    std::vector<GLuint> assembly; ///< program objects of the host's ARB path
  };
  /// Empties the cache without touching the host.
  [[nodiscard]] Names abandon();
  /// The number of linked programs.
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
  /// What the host has of one program; both only where it is drawn with in both ways.
  struct HostObjects {
    std::shared_ptr<const CompiledProgram> compiled; ///< keeps the linked programs' pointers alive
    std::optional<GLuint> shader;                    ///< 0: the host refused it
    std::vector<std::unique_ptr<AssemblyProgram>> assembly; ///< by `defined`: mostly one
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

/// True where a vertex program is drawn with by the host's own ARB path: the host has one, and the
/// arithmetic is the host's, as no other can be written in assembly.
[[nodiscard]] bool drawsVerticesByAssembly(const Context &context);

/// Brings the host's uniforms of the effective linked program up to date, as far as `attention`
/// says that they may have changed; its host program is current. No allocation, one call a run of
/// changed values.
void uploadParameters(Context &context, LinkedProgram &linkedProgram, std::uint32_t attention);
/// The value that a parameter has now; `row`: the effective program's.
[[nodiscard]] Vec4 currentValue(Context &context, const ProgramTarget &row,
                                const fp::ir::Parameter &parameter);
/// What the application gave an env or local parameter.
[[nodiscard]] inline Vec4 givenValue(const ProgramTarget &row, bool env, std::size_t index) {
  if (env)
    return index < row.env.size() ? row.env[index] : Vec4{};
  return index < row.bound->locals.size() ? row.bound->locals[index].load() : Vec4{};
}
/// The value of one that is no row of state, while no client of control holds any.
[[nodiscard]] inline Vec4 ownValue(const ProgramTarget &row, const fp::ir::Parameter &parameter) {
  return parameter.kind == fp::ir::ParameterKind::Constant
             ? parameter.constant
             : givenValue(row, parameter.kind == fp::ir::ParameterKind::Env, parameter.index);
}
/// Bits, not values: a NaN would be sent for ever, and -0 never.
[[nodiscard]] inline bool sameBits(const Vec4 &a, const Vec4 &b) {
  using Halves = std::array<std::uint64_t, 2>;
  return std::bit_cast<Halves>(a) == std::bit_cast<Halves>(b);
}

/// The value of one row of GL state (3.11.3.2), from the host.
void fetchState(Context &context, const fp::ir::StateRef &state, GLfloat value[4]);
/// All rows of the matrix that a row of state is of, its modifier applied.
void fetchMatrix(Context &context, const fp::ir::StateRef &state, GLfloat rows[4][4]);

} // namespace arbiter::state
