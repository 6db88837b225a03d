#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp {

/// Counts the nodes of the texture dependency chain by the API's rule (3.11.6). The rule ignores
/// masks and suffixes, and considers only temporaries.
class IndirectionCounter {
public:
  /// Adds an instruction. Returns true if it begins a new node.
  bool add(const ir::Instruction &instruction);

private:
  /// The node in which a temporary was last used; 0 for never.
  struct Touched {
    std::uint32_t written = 0;
    std::uint32_t byAlu = 0;
  };
  Touched &touched(std::uint16_t temporary);

  std::uint32_t m_node = 1;
  std::vector<Touched> m_temporaries;
};

} // namespace arbiter::fp
