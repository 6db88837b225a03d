#pragma once
#include <cstdint>

#include "fp_compiler/ir/ir.h"

namespace arbiter::r300 {

/// What a program costs by the slot tables when nothing is shared, paired, reordered or dropped: an
/// operation a slot. A compiler that is worth its name is never above.
struct NaiveCounts {
  std::uint32_t pairs = 0, textures = 0, nodes = 1;
};
[[nodiscard]] NaiveCounts naiveCounts(const fp::ir::Program &program, bool scaleRectangles);

} // namespace arbiter::r300
