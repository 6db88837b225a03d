#pragma once
#include <memory>
#include <unordered_map>
#include <vector>

#include "state/program_object.h"

namespace arbiter::state {

class Context;

/// A compiled program as the host's GLSL program, in one context. Each context has its own because
/// a host program holds its uniform values, and contexts of a share group draw on different
/// threads.
struct Variant {
  std::shared_ptr<const CompiledProgram> compiled;
  GLuint hostProgram = 0;       ///< 0: the host refused it
  std::vector<GLint> locations; ///< of `arb_param[i]`; -1 where the host dropped it
  std::vector<Vec4> uploaded;   ///< what the host holds
  bool readsState = false;      ///< has uniforms of kind State
  bool readsParameters = false; ///< has uniforms at all
  bool hasPlainSamplers = false;
};

/// The variants of a context.
class VariantCache {
public:
  constexpr VariantCache() = default;
  /// The variant of `compiled`; built at the first call, in which case the host compiles and links.
  /// Raises no error; a variant that the host refused has hostProgram 0.
  [[nodiscard]] Variant *get(Context &context,
                             const std::shared_ptr<const CompiledProgram> &compiled);
  /// Deletes the variant of a compiled program that left its object. `context` is current.
  void drop(Context &context, const CompiledProgram *compiled);
  /// Empties the cache without touching the host; gives the host programs' names.
  [[nodiscard]] std::vector<GLuint> abandon();
  [[nodiscard]] std::size_t size() const { return m_map ? m_map->size() : 0; }

private:
  using Map = std::unordered_map<const CompiledProgram *, std::unique_ptr<Variant>>;
  void sweep(Context &context);

  std::unique_ptr<Map> m_map; ///< null until the first: the null context is a constant
  std::size_t m_sweepAt = 64;
};

/// Brings the host's uniforms of the variant in force up to date; its host program is current.
/// No allocation, one call a run of changed values.
void uploadParameters(Context &context, Variant &variant);

/// The value of one row of GL state (3.11.3.2), from the host.
void fetchState(Context &context, const fp::ir::StateRef &state, GLfloat value[4]);

} // namespace arbiter::state
