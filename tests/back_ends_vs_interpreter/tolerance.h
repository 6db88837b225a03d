#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::differential {

/// The allowed difference of a host's opcode result from the interpreter's. The host may have used
/// operands that differ by `operand` (relative), and its result may differ by `relative` and
/// `absolute`. Differences propagate through later instructions.
struct Tolerance {
  float operand = 0;
  float relative = 0;
  float absolute = 0;
};

/// Returns an opcode's tolerance. In Fp24 every operation except the functions is exact to the last
/// bit; a function's result may be rounded to the other neighbor.
[[nodiscard]] Tolerance tolerance(fp::ir::Opcode op, fp::Numerics numerics);

/// True for opcodes that add and multiply, which is exact on small whole numbers.
[[nodiscard]] bool sumsProducts(fp::ir::Opcode op);

/// The tolerance of the last step to a pixel: interpolation, the fog blend, the store.
inline constexpr float kPixelTolerance = 1e-6f;

/// If results spread wider than this, relative to 1 + |result|, a pixel is not judged.
inline constexpr float kIllConditioned = 0.02f;

} // namespace arbiter::differential
