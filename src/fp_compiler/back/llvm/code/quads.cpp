#include "fp_compiler/back/llvm/code/quads.h"

namespace arbiter::fp::llvm_back {

namespace {
/// Returns the value of another pixel of each lane's quad.
/// \param to maps a pixel's place in the quad (bit 0 x, bit 1 y) to the place to read
template <typename F> Value *ofPixel(Code &code, Value *value, F to) {
  const int width = code.cpu.blockWidth();
  llvm::SmallVector<int, 16> from;
  for (int lane = 0; lane < code.lanes; ++lane) {
    const int x = lane % width, y = lane / width;
    const int place = to((y & 1) * 2 + (x & 1));
    from.push_back(((y & ~1) + (place >> 1)) * width + (x & ~1) + (place & 1));
  }
  return code.ir.CreateShuffleVector(value, from);
}
} // namespace

Value *atCorner(Code &code, Value *value, int dx, int dy) {
  return ofPixel(code, value, [&](int) { return dy * 2 + dx; });
}

void addQuadDerivatives(Code &code, SampleAt &at, int count, Value *upper) {
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    Value *value = at.coordinate[i];
    if (upper)
      value = code.ir.CreateSelect(upper, ofPixel(code, value, [](int place) { return place ^ 2; }),
                                   value);
    Value *const here = atCorner(code, value, 0, 0);
    at.dx[i] = code.ir.CreateFSub(atCorner(code, value, 1, 0), here);
    at.dy[i] = code.ir.CreateFSub(atCorner(code, value, 0, 1), here);
  }
}

Value *changeInQuad(Code &code, Value *value, bool upwards) {
  const int bit = upwards ? 2 : 1;
  Value *const low = ofPixel(code, value, [&](int place) { return place & ~bit; });
  Value *const high = ofPixel(code, value, [&](int place) { return place | bit; });
  return code.ir.CreateFSub(high, low);
}

void addPixelDerivatives(Code &code, SampleAt &at, int count) {
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    at.dx[i] = changeInQuad(code, at.coordinate[i], false);
    at.dy[i] = changeInQuad(code, at.coordinate[i], true);
  }
}

Value *wholeQuads(Code &code, Value *mask) {
  Value *all = mask;
  for (const int bit : {1, 2})
    all = code.ir.CreateAnd(all, ofPixel(code, all, [&](int place) { return place ^ bit; }));
  return all;
}

} // namespace arbiter::fp::llvm_back
