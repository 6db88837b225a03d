#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// The place of attribute components that only VertexAttribNV sets (attribute_forms.h).
enum class WiderAttributes : std::uint8_t {
  Beside, ///< in the generic attribute, beside the conventional one
  /// in the generic attribute, which aliases the conventional one: GLSL may read only one of them
  Generic,
  Nowhere,
};

/// The variants of a vertex program by enabled arrays, where attributes alias, as in NVIDIA's own
/// languages. Register n is the conventional attribute of that number (NV_vertex_program, table
/// X.2), but if the generic array is enabled it is the generic one (2.14.3). On the host these are
/// different attributes. The generic one also holds components that only VertexAttribNV sets
/// (attribute_forms.h). Each variant is emitted once, and contexts of a share group use the same
/// ones.
class ArrayVariants {
public:
  /// \param distances true if the host has GLSL 1.30, in which clip distances are written
  ArrayVariants(const fp::ir::Program &whole, fp::GlslHost host, fp::Numerics numerics,
                bool distances);

  /// Returns the variant of `whole`, the program that this object belongs to. It reads generic
  /// attributes where `arrays` has a bit, and the components of `wider`. Returns `whole` itself if
  /// it reads none of these. Any thread may call it.
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  of(const CompiledProgram &whole, std::uint32_t arrays, WiderAttributes wider) const;
  /// True if the program reads a component that only VertexAttribNV sets.
  [[nodiscard]] bool readsWider() const { return m_beyond != 0; }
  /// Returns all variants made so far.
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    return m_forms.all();
  }

private:
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  bool m_distances;
  std::uint32_t m_beyond; ///< the result of readsBeyondConventional()
  std::uint32_t m_read;   ///< the aliased registers that the program reads
  Forms<std::uint32_t> m_forms;
};

} // namespace arbiter::state
