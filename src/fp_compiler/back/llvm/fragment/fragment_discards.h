#pragma once
#include <optional>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// The part of a program that decides which fragments are discarded: its KILs, and the alpha that
/// is tested. It has the inputs of the whole program.
class DiscardProgram final : public jit::FragmentProgram {
public:
  DiscardProgram(ir::Program program, const jit::FragmentShape &shape)
      : m_program(std::move(program)), m_shape(shape) {}
  [[nodiscard]] const jit::FragmentShape &shape() const override { return m_shape; }
  [[nodiscard]] const ir::Program &program() const override { return m_program; }

private:
  ir::Program m_program;
  const jit::FragmentShape &m_shape;
};

/// Returns the part of the program that decides discards, or nothing if it does not pay. It does
/// not if the part takes the same samples as the program, or if its samples would be taken twice.
/// Otherwise the part costs nothing, because the whole program reuses its values. Requires: \p
/// program outlives the result.
[[nodiscard]] std::optional<DiscardProgram> discardProgramOf(const jit::FragmentProgram &program,
                                                             const abi::FragmentKey &key);

} // namespace arbiter::fp::llvm_back
