#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/analysis/value_range.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// Which factors of a product have to be compared with zero, because the other one may be an
/// infinity or NaN (Numerics::Legacy); bits.
enum class Guard : std::uint8_t { None = 0, Left = 1, Right = 2, Both = 3 };

/// What is known of an instruction's operands.
struct OperandFacts {
  bool baseNotNegative = false; ///< POW's or LIT's: >= 0 and no NaN
  bool exponentNotZero = false;
  bool exponentPositive = false;
  bool exponentFinite = false;
  Guard first = Guard::None;  ///< of the product a*b, over all components that count
  Guard second = Guard::None; ///< of LRP's (1-a)*c, or of XPD's second product
};

/// Follows straight-line code and knows the range of every temporary's components, so that guards
/// that can never fire are not emitted.
class RangeAnalysis {
public:
  /// \param numerics that the program follows (ir::numericsOf)
  RangeAnalysis(const ir::Program &program, Numerics numerics);

  /// What may be left out of the instruction that is about to be emitted.
  [[nodiscard]] OperandFacts facts(const ir::Instruction &instruction) const;
  /// Goes past the instruction.
  void step(const ir::Instruction &instruction);
  /// Nothing is known any more: code begins that may be run again.
  void forget();
  /// What is known of a temporary now.
  [[nodiscard]] const ValueRange4 &temporary(std::uint16_t index) const {
    return m_temporaries[index];
  }

private:
  /// Of an operand after its swizzle and sign: one component, by the destination's position; all.
  [[nodiscard]] ValueRange operand(const ir::Operand &source, int position) const;
  [[nodiscard]] ValueRange4 operand(const ir::Operand &source) const;
  /// Of a register's component, before swizzle and sign.
  [[nodiscard]] ValueRange read(const ir::Operand &source, std::size_t component) const;
  [[nodiscard]] std::array<ValueRange4, 3> operands(const ir::Instruction &instruction) const;
  /// What POW, or LIT's power, need not guard against.
  void findBaseFacts(OperandFacts &facts, const ir::Operand &base, int basePosition,
                     const ir::Operand &exponent, int exponentPosition) const;
  /// Which products cannot be zero times infinity or NaN (OperandFacts::first, second).
  void findProductFacts(OperandFacts &facts, const ir::Instruction &instruction) const;

  const ir::Program &m_program;
  Numerics m_numerics;
  std::vector<ValueRange4> m_temporaries;
};

} // namespace arbiter::fp::analysis
