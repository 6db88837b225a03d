#pragma once
#include <array>
#include <vector>

#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// What is known of a value: each step includes the ones before it.
enum class Range : std::uint8_t {
  Any,
  NotNegative, ///< >= -0, may be infinite, no NaN
  Unit,        ///< in [0,1]
};

/// Follows straight-line code and knows the range of every temporary's components, so that guards
/// that can never fire are not emitted.
class Ranges {
public:
  explicit Ranges(const ir::Program &program);

  /// What may be left out of the instruction that is about to be emitted.
  [[nodiscard]] Proofs proofs(const ir::Instruction &instruction) const;
  /// Goes past the instruction.
  void step(const ir::Instruction &instruction);

private:
  [[nodiscard]] Range operand(const ir::Operand &source, int position) const;
  [[nodiscard]] Range result(const ir::Instruction &instruction, int position) const;
  [[nodiscard]] Proofs proofs(const ir::Operand &base, int basePosition,
                              const ir::Operand &exponent, int exponentPosition) const;

  const ir::Program &m_program;
  std::vector<std::array<Range, 4>> m_temporaries;
};

} // namespace arbiter::fp::glsl
