#pragma once

#include "fp_compiler/back/llvm/code/code.h"

/// Lanes that are 2x2 quads of pixels.
namespace arbiter::fp::llvm_back {

/// In each lane the value of one pixel of its quad: dx, dy in {0, 1}, (0, 0) the first in x and y.
[[nodiscard]] Value *atCorner(Code &code, Value *value, int dx, int dy);

/// Sets \p at's dx and dy of the first `count` coordinates: their changes a pixel in x and in y, as
/// differences in the quad, along x in its lower row, which all four pixels share. \param upper an
/// i1 that is the same for all: the upper row instead
void addQuadDerivatives(Code &code, SampleAt &at, int count, Value *upper);

/// A value's change from one pixel of the quad to the next, in each of its rows by itself, or, \p
/// upwards, in each of its columns: the same in both pixels that are compared.
[[nodiscard]] Value *changeInQuad(Code &code, Value *value, bool upwards);

/// The same by changeInQuad(): each row and each column of the quad has changes of its own. They
/// are what software hosts take the levels of cube maps by, and the others those of all other
/// textures.
void addPixelDerivatives(Code &code, SampleAt &at, int count);

/// Of \p mask, an i1 a lane, the quads of which all four pixels are in it.
[[nodiscard]] Value *wholeQuads(Code &code, Value *mask);

} // namespace arbiter::fp::llvm_back
