#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/analysis/value_range.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::analysis {

/// The factors of a product that must be compared with zero, as bits. Numerics::Legacy needs this
/// if the other factor may be infinite or NaN.
enum class Guard : std::uint8_t { None = 0, Left = 1, Right = 2, Both = 3 };

/// Facts about the operands of an instruction. They allow guards to be omitted.
struct OperandFacts {
  bool baseNotNegative = false; ///< base of POW or LIT: >= 0 and not NaN
  bool exponentNotZero = false;
  bool exponentPositive = false;
  bool exponentFinite = false;
  Guard first = Guard::None;  ///< for the product a*b, over all live components
  Guard second = Guard::None; ///< for LRP's (1-a)*c, or for XPD's second product
};

/// Tracks the value range of every temporary component along straight-line code. Code generators
/// use it to omit guards that can never fire.
class RangeAnalysis {
public:
  /// \param numerics the arithmetic that the program follows (ir::numericsOf)
  RangeAnalysis(const ir::Program &program, Numerics numerics);

  /// Returns the facts about the operands of the instruction that is about to be emitted.
  [[nodiscard]] OperandFacts facts(const ir::Instruction &instruction) const;
  /// Updates the ranges for the result of \p instruction.
  void step(const ir::Instruction &instruction);
  /// Discards all ranges, at the start of code that may run again.
  void forget();
  /// Returns the current ranges of a temporary.
  [[nodiscard]] const ValueRange4 &temporary(std::uint16_t index) const {
    return m_temporaries[index];
  }

private:
  /// Returns the range of an operand after swizzle and sign, at one destination component or at
  /// all.
  [[nodiscard]] ValueRange operand(const ir::Operand &source, int position) const;
  [[nodiscard]] ValueRange4 operand(const ir::Operand &source) const;
  /// Returns the range of a register component before swizzle and sign.
  [[nodiscard]] ValueRange read(const ir::Operand &source, std::size_t component) const;
  [[nodiscard]] std::array<ValueRange4, 3> operands(const ir::Instruction &instruction) const;
  /// Fills in the facts about the base and the exponent of POW or LIT.
  void findBaseFacts(OperandFacts &facts, const ir::Operand &base, int basePosition,
                     const ir::Operand &exponent, int exponentPosition) const;
  /// Fills in OperandFacts::first and second: the products that may be zero times infinity or NaN.
  void findProductFacts(OperandFacts &facts, const ir::Instruction &instruction) const;

  const ir::Program &m_program;
  Numerics m_numerics;
  std::vector<ValueRange4> m_temporaries;
};

} // namespace arbiter::fp::analysis
