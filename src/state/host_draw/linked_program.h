#pragma once
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

#include "state/programs/program_object.h"

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

/// A pair of compiled programs as the host's GLSL program, in one context. Each context has its own
/// because a host program holds its uniform values, and contexts of a share group draw on different
/// threads.
struct LinkedProgram {
  GLuint hostProgram = 0; ///< 0: the host refused it
  LinkedProgramStage vertex;
  LinkedProgramStage fragment;
  bool readsState = false; ///< either stage does
  bool hasPlainSamplers = false;
};

/// The linked programs of a context, and the host's shader objects that they are linked from: each
/// program is compiled once, however many it is paired with.
class LinkedProgramCache {
public:
  /// The linked program of `pair`, of which one program at least is not null; built at the first
  /// call, in which case the host links, and compiles what it has not compiled yet. Raises no
  /// error; a linked program that the host refused has hostProgram 0.
  [[nodiscard]] LinkedProgram *get(Context &context, const ProgramPair &pair);
  /// Deletes the shader and the linked programs of a compiled program that left its object.
  /// `context` is current.
  void drop(Context &context, const CompiledProgram *compiled);

  /// Host objects, for the context that deletes them.
  struct Names {
    std::vector<GLuint> programs;
    std::vector<GLuint> shaders;
  };
  /// Empties the cache without touching the host.
  [[nodiscard]] Names abandon();
  /// The number of linked programs.
  [[nodiscard]] std::size_t size() const { return m_linkedPrograms.size(); }

private:
  struct Key {
    const CompiledProgram *vertex;
    const CompiledProgram *fragment;
    bool operator==(const Key &) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key &key) const {
      const std::hash<const void *> hash;
      return hash(key.vertex) * 31 + hash(key.fragment);
    }
  };
  struct Shader {
    std::shared_ptr<const CompiledProgram> compiled; ///< keeps the linked programs' pointers alive
    GLuint name = 0;                                 ///< 0: the host refused it
  };
  [[nodiscard]] const Shader *shaderOf(Context &context,
                                       const std::shared_ptr<const CompiledProgram> &compiled);
  [[nodiscard]] std::unique_ptr<LinkedProgram> build(Context &context, const ProgramPair &pair);
  void sweep(Context &context);

  std::unordered_map<Key, std::unique_ptr<LinkedProgram>, KeyHash> m_linkedPrograms;
  std::unordered_map<const CompiledProgram *, Shader> m_shaders;
  std::size_t m_sweepAt = 64;
};

/// Brings the host's uniforms of the effective linked program up to date, as far as `attention`
/// says that they may have changed; its host program is current. No allocation, one call a run of
/// changed values.
void uploadParameters(Context &context, LinkedProgram &linkedProgram, std::uint32_t attention);

/// The value of one row of GL state (3.11.3.2), from the host.
void fetchState(Context &context, const fp::ir::StateRef &state, GLfloat value[4]);
/// All rows of the matrix that a row of state is of, its modifier applied.
void fetchMatrix(Context &context, const fp::ir::StateRef &state, GLfloat rows[4][4]);

} // namespace arbiter::state
