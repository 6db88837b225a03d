#pragma once

#include "fp_compiler/back/llvm/code/code.h"

/// Functions on lanes that are 2x2 quads of pixels.
namespace arbiter::fp::llvm_back {

/// Returns in each lane the value of one pixel of its quad: dx, dy in {0, 1}, where (0, 0) is the
/// first in x and y.
[[nodiscard]] Value *atCorner(Code &code, Value *value, int dx, int dy);

/// Sets the derivatives \p at.dx and \p at.dy of the first `count` coordinates. They are
/// differences in the quad, shared by its four pixels. The one along x is from the lower row.
/// \param upper a uniform i1, or null: true takes the upper row instead
void addQuadDerivatives(Code &code, SampleAt &at, int count, Value *upper);

/// Returns the difference between neighbouring pixels in each row of the quad, or with \p upwards
/// in each column. Both pixels get the same difference.
[[nodiscard]] Value *changeInQuad(Code &code, Value *value, bool upwards);

/// Sets the derivatives by changeInQuad(), so that each row and column of the quad has its own.
/// Software hosts use these for the levels of cube maps, and those of addQuadDerivatives() for all
/// other textures.
void addPixelDerivatives(Code &code, SampleAt &at, int count);

/// Returns a mask (i1 lanes) of the quads whose four pixels are all in \p mask.
[[nodiscard]] Value *wholeQuads(Code &code, Value *mask);

} // namespace arbiter::fp::llvm_back
