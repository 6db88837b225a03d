#pragma once
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::opt {

/// Which registers may hold bits that are no number of the mode: in programs under NVIDIA's options
/// MOV, SWZ and CMP copy what PK*, UP* and parameters give, denormals and the NaNs of packing, and
/// every other opcode reads and makes numbers (ir/semantics.h). There a copy is not what an
/// arithmetic identity makes.
class HeldBits {
public:
  HeldBits(const ir::Program &program, Numerics numerics);
  /// False where a MOV of the operand gives what arithmetic reads of it.
  [[nodiscard]] bool mayBeIn(const ir::Operand &operand) const;

private:
  const ir::Program &m_program;
  const bool m_inParameters;
  std::vector<bool> m_temporaries; ///< empty where the options are none of NVIDIA's
};

} // namespace arbiter::fp::opt
