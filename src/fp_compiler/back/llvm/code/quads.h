#pragma once

#include "fp_compiler/back/llvm/code/code.h"

/// Lanes that are 2x2 quads of pixels.
namespace arbiter::fp::llvm_back {

/// Each lane's value at a corner of its quad: dx, dy in {0, 1}.
[[nodiscard]] Value *atCorner(Code &code, Value *value, int dx, int dy);

/// The changes of `count` coordinates a pixel in x and in y, as differences in the quad: along x in
/// its lower row, which all four pixels share. \param upper an i1 that is the same for all: the
/// upper row instead
void addQuadDerivatives(Code &code, SampleAt &at, int count, Value *upper);

} // namespace arbiter::fp::llvm_back
