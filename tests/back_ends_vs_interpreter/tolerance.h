#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/numerics.h"

namespace arbiter::differential {

/// How far a host's result of one opcode may be from the interpreter's: the host may have used
/// operands that differ by `operand` (relative), and its result may differ by `relative` and
/// `absolute`. Differences of one instruction spread through the ones after it.
struct Tolerance {
  float operand = 0;
  float relative = 0;
  float absolute = 0;
};

/// In Fp24 every single operation but the functions is exact to the last bit; a function's result
/// may be rounded to the other neighbour.
[[nodiscard]] Tolerance tolerance(fp::ir::Opcode op, fp::Numerics numerics);

/// True of opcodes that add and multiply, which is exact on small whole numbers.
[[nodiscard]] bool sumsProducts(fp::ir::Opcode op);

/// Of the last step to a pixel: interpolation, the fog blend, the store.
inline constexpr float kPixelTolerance = 1e-6f;

/// Beyond this spread of possible results, relative to 1 + |result|, a pixel says nothing.
inline constexpr float kIllConditioned = 0.02f;

} // namespace arbiter::differential
