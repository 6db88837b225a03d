#pragma once
#include <array>
#include <vector>

#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/back/glsl/known.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// Follows straight-line code and knows the range of every temporary's components, so that guards
/// that can never fire are not emitted.
class Ranges {
public:
  /// \param numerics that the program follows (ir::numericsOf)
  Ranges(const ir::Program &program, Numerics numerics);

  /// What may be left out of the instruction that is about to be emitted.
  [[nodiscard]] Proofs proofs(const ir::Instruction &instruction) const;
  /// Goes past the instruction.
  void step(const ir::Instruction &instruction);
  /// What is known of a temporary now.
  [[nodiscard]] const Known4 &temporary(std::uint16_t index) const { return m_temporaries[index]; }

private:
  [[nodiscard]] Known operand(const ir::Operand &source, int position) const;
  [[nodiscard]] Known4 operand(const ir::Operand &source) const;
  [[nodiscard]] Known read(const ir::Operand &source, std::size_t component) const;
  [[nodiscard]] std::array<Known4, 3> operands(const ir::Instruction &instruction) const;
  void proveBase(Proofs &proofs, const ir::Operand &base, int basePosition,
                 const ir::Operand &exponent, int exponentPosition) const;
  void proveProducts(Proofs &proofs, const ir::Instruction &instruction) const;

  const ir::Program &m_program;
  Numerics m_numerics;
  std::vector<Known4> m_temporaries;
};

} // namespace arbiter::fp::glsl
