#pragma once
#include <array>
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/ir/ir.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// An ATI fragment shader, and what it becomes under the fixed-function state of draws: its samples
/// name no texture targets, and fog and colour sum follow it. Each form is emitted once; contexts
/// of a share group use the same ones.
class AtiVariants {
public:
  /// `program` is checked, of language AtiFragment.
  AtiVariants(fp::ir::Program program, fp::GlslHost host, fp::Numerics numerics);

  /// The image units that it samples, one bit each.
  [[nodiscard]] std::uint32_t units() const { return m_units; }
  /// The form under `state`, of which units that it does not sample are not looked at: its GLSL,
  /// and as its text the assembly for the host's ARB path. `whole` is the program that this is the
  /// shader of. Any thread may call it.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> under(const CompiledProgram &whole,
                                                             const fp::FixedFunction &state) const;
  /// The forms there are.
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
