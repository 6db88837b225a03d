#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// Where a program finds what VertexAttribNV alone sets of an attribute (attribute_forms.h).
enum class WiderAttributes : std::uint8_t {
  Beside,  ///< in the generic attribute, beside the conventional one
  Generic, ///< in the generic attribute, which is the conventional one: GLSL may read one of them
  Nowhere,
};

/// The forms of a vertex program by the arrays that it is drawn with, where attributes alias, as
/// they do in NVIDIA's own languages. Register n is the conventional attribute of that number
/// (NV_vertex_program, table X.2), but where the generic array is enabled that is (2.14.3): on the
/// host it is another attribute there, and what VertexAttribNV alone sets of an attribute is in
/// that too (attribute_forms.h). Each form is emitted once; contexts of a share group use the same
/// ones.
class ArrayVariants {
public:
  /// \param distances the host has GLSL 1.30, in which clip distances are written
  ArrayVariants(const fp::ir::Program &whole, fp::GlslHost host, fp::Numerics numerics,
                bool distances);

  /// The form of `whole`, which this is the one of, that reads generic attributes where `arrays`
  /// has a bit, and what VertexAttribNV sets beyond the conventional attributes; `whole` itself
  /// where it reads none of that. Any thread may call it.
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  of(const CompiledProgram &whole, std::uint32_t arrays, WiderAttributes wider) const;
  /// The program reads what VertexAttribNV alone sets of some attribute.
  [[nodiscard]] bool readsWider() const { return m_beyond != 0; }
  /// The forms there are.
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    return m_forms.all();
  }

private:
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  bool m_distances;
  std::uint32_t m_beyond; ///< readsBeyondConventional()
  std::uint32_t m_read;   ///< the aliased registers that the program reads
  Forms<std::uint32_t> m_forms;
};

} // namespace arbiter::state
