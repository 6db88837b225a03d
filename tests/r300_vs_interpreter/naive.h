#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::r300 {

/// A program's cost by the slot tables, with one operation in each slot and nothing shared, paired,
/// reordered or dropped. The compiler must never exceed it.
struct NaiveCounts {
  std::uint32_t pairs = 0, textures = 0, nodes = 1;
};
[[nodiscard]] NaiveCounts naiveCounts(const fp::ir::Program &program, bool scaleRectangles);

} // namespace arbiter::r300
