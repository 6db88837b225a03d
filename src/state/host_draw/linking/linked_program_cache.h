#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "state/objects/linked_program.h"

namespace arbiter::state {

class Context;

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

} // namespace arbiter::state
