#pragma once
#include <vector>

#include "fp_compiler/opt/ir_names.h"

namespace arbiter::fp::opt {

/// Finds registers that may hold raw bits instead of numbers. Under NVIDIA's options MOV, SWZ and
/// CMP copy bits unchanged: PK*, UP* and parameters produce denormals and NaN payloads. All other
/// opcodes flush what they read (ir/semantics.h). In such programs a copy is not equivalent to an
/// arithmetic identity.
class HeldBits {
public:
  HeldBits(const ir::Program &program, Numerics numerics);
  /// True if a MOV of the operand may differ from what arithmetic reads. False if they are equal.
  [[nodiscard]] bool mayBeIn(const ir::Operand &operand) const;

private:
  const ir::Program &m_program;
  const bool m_inParameters;
  std::vector<bool> m_temporaries; ///< empty unless one of NVIDIA's options is set
};

} // namespace arbiter::fp::opt
