#pragma once
#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::llvm_back {

/// Operands after swizzle and negation; a scalar operand is in x. Unused components may be null.
using OperandValues = std::array<Vec, 3>;

/// Returns the result of an arithmetic opcode before _SAT, as ir/semantics.h defines it. Components
/// outside \p needed are null.
/// Requires: the opcode is neither Texture nor Kills nor Flow nor ARL; \p numerics is Host or
/// Legacy.
/// \param facts guards that are unnecessary in Legacy
/// \param language the program's language: vertex programs have another order of sums
[[nodiscard]] Vec apply(Code &code, ir::Opcode op, const OperandValues &operands, unsigned needed,
                        const analysis::OperandFacts &facts, Numerics numerics,
                        ir::Language language = ir::Language::ArbFragment);

/// Returns KIL's condition as i1 lanes.
[[nodiscard]] Value *kills(Code &code, const Vec &operand);

} // namespace arbiter::fp::llvm_back
