#pragma once
#include <array>
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/ir/ir.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// An ATI fragment shader, with its variants by fixed-function state. Its samples name no texture
/// targets, and it is followed by fog and colour sum. Each variant is emitted once, and contexts of
/// a share group use the same ones.
class AtiVariants {
public:
  /// Requires that `program` is checked, of language AtiFragment.
  AtiVariants(fp::ir::Program program, fp::GlslHost host, fp::Numerics numerics);

  /// Returns the image units that it samples, one bit for each.
  [[nodiscard]] std::uint32_t units() const { return m_units; }
  /// Returns the variant under `state`: its GLSL, and as its text the assembly for the host's ARB
  /// path. The state of units that it does not sample is ignored. `whole` is the program that this
  /// object belongs to. Any thread may call it.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> under(const CompiledProgram &whole,
                                                             const fp::FixedFunction &state) const;
  /// Returns all variants made so far.
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    return m_forms.all();
  }

private:
  fp::ir::Program m_program;
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  std::uint32_t m_units = 0;
  Forms<fp::FixedFunction> m_forms;
};

} // namespace arbiter::state
