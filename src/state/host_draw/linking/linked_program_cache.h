#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "state/objects/linked_program.h"

namespace arbiter::state {

struct DrawContext;

/// The linked programs of a context, with the host's shaders and programs that they consist of.
/// Each program is compiled once, however many it is paired with.
class LinkedProgramCache {
public:
  /// The form of the fragment program on the host. It is GLSL anyway if the host refuses the
  /// assembly, or if the vertex program is GLSL, with which assembly cannot be combined.
  enum class Fragments : std::uint8_t { Glsl, Assembly };
  /// Returns the linked program of `pair`, which must have at least one program. The first call
  /// builds it: the host links it, and compiles what it has not compiled yet. Raises no error.
  [[nodiscard]] LinkedProgram *get(DrawContext &context, const ProgramPair &pair,
                                   Fragments fragments = Fragments::Glsl);
  /// Returns the cache entry of `pair` without building it.
  [[nodiscard]] LinkedProgram *place(DrawContext &context, const ProgramPair &pair,
                                     Fragments fragments = Fragments::Glsl);
  /// Returns the cache entry of `pair`, or null if there is none.
  [[nodiscard]] const LinkedProgram *find(const ProgramPair &pair, Fragments fragments) const;
  /// Returns the program as an object of the host's own ARB path. It is loaded at the first call,
  /// from text that the layer's compiler has checked within its limits. Each has an object of its
  /// own, because a host may crash if one is loaded again and again. Returns null if the host
  /// refuses it. Raises no error.
  /// \param defined additional results that a vertex program must write
  [[nodiscard]] AssemblyProgram *assemblyOf(DrawContext &context,
                                            const std::shared_ptr<const CompiledProgram> &compiled,
                                            const std::vector<fp::ir::Output> &defined = {});
  /// Deletes the host's objects and the linked programs of a compiled program that left its object.
  /// Requires that `context` is current.
  void drop(DrawContext &context, const CompiledProgram *compiled);

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
  [[nodiscard]] GLuint shaderOf(DrawContext &context,
                                const std::shared_ptr<const CompiledProgram> &compiled);
  void build(DrawContext &context, const ProgramPair &pair, Fragments fragments,
             LinkedProgram &linkedProgram);
  [[nodiscard]] bool buildOnAssembly(DrawContext &context, const ProgramPair &pair,
                                     Fragments fragments, LinkedProgram &linkedProgram);
  [[nodiscard]] bool takeFragmentAssembly(DrawContext &context,
                                          const std::shared_ptr<const CompiledProgram> &fragment,
                                          LinkedProgram &linkedProgram);
  [[nodiscard]] bool buildApart(DrawContext &context, const ProgramPair &pair,
                                LinkedProgram &linkedProgram);
  void deleteObjects(DrawContext &context, const HostObjects &objects);
  void sweep(DrawContext &context);

  std::unordered_map<Key, std::unique_ptr<LinkedProgram>, KeyHash> m_linkedPrograms;
  std::unordered_map<const CompiledProgram *, HostObjects> m_objects;
  std::size_t m_sweepAt = 64;
};

/// True if vertex programs are drawn with the host's own ARB path. The host must have one, and
/// numerics must be the host's, because assembly cannot express other numerics.
[[nodiscard]] bool drawsVerticesByAssembly(const DrawContext &context);

} // namespace arbiter::state
