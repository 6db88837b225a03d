#pragma once
#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// Operands swizzled and negated; a scalar one stands in x. What nothing reads may be null.
using OperandValues = std::array<Vec, 3>;

/// The result of an arithmetic opcode as ir/semantics.h says, before _SAT, in the components of
/// \p needed; others are null.
/// Requires: the opcode is neither Texture nor Kills nor Flow nor ARL; \p numerics is Host or
/// Legacy.
/// \param facts what need not be guarded in Legacy
/// \param language the program's: of vertex programs the order of sums is another
[[nodiscard]] Vec apply(Code &code, ir::Opcode op, const OperandValues &operands, unsigned needed,
                        const analysis::OperandFacts &facts, Numerics numerics,
                        ir::Language language = ir::Language::ArbFragment);

/// KIL's condition: one i1 a lane.
[[nodiscard]] Value *kills(Code &code, const Vec &operand);

} // namespace arbiter::fp::llvm_back
