#pragma once
#include <optional>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"

namespace arbiter::fp::llvm_back {

/// What of a program decides which of its fragments are discarded: its KILs, and the alpha that is
/// tested. Its inputs are the whole program's.
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

/// Nothing where a vector of fragments that are all discarded had better be shaded as a whole: the
/// part samples what the whole does, or so that its samples would be taken twice. Written before
/// the whole program, the part costs nothing: the whole reads its values again.
/// Requires: \p program lives as long as what is returned.
[[nodiscard]] std::optional<DiscardProgram> discardProgramOf(const jit::FragmentProgram &program,
                                                             const abi::FragmentKey &key);

} // namespace arbiter::fp::llvm_back
