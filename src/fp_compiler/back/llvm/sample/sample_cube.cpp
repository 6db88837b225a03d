#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/sample/sample_parts.h"

namespace arbiter::fp::llvm_back {

CubeFace::CubeFace(Code &code, const Vec &direction) : m_code(code) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *const x = absolute(code, direction[0]);
  Value *const y = absolute(code, direction[1]);
  Value *const z = absolute(code, direction[2]);
  // Table 3.21 leaves ties open. Hosts prefer z to y to x, and use the sign of a zero.
  m_majorZ = ir.CreateAnd(ir.CreateFCmpOGE(z, x), ir.CreateFCmpOGE(z, y));
  m_majorX = ir.CreateAnd(ir.CreateNot(m_majorZ), ir.CreateFCmpOGT(x, y));
  Value *const major =
      code.select(m_majorZ, direction[2], code.select(m_majorX, direction[0], direction[1]));
  m_negative = ir.CreateICmpSLT(ir.CreateBitCast(major, code.i32), code.splat(0));
  Value *const axis =
      code.select(m_majorZ, code.splat(4), code.select(m_majorX, code.splat(0), code.splat(2)));
  m_face = ir.CreateOr(axis, ir.CreateZExt(m_negative, code.i32));
  m_turned = turned(direction);
  // A zero direction gives the middle of a face.
  m_inverse = code.select(ir.CreateFCmpOEQ(m_turned[2], code.splat(0.0f)), code.splat(0.0f),
                          ir.CreateFDiv(code.splat(1.0f), m_turned[2]));
}

Vec CubeFace::turned(const Vec &d) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  Value *const minusX = ir.CreateFNeg(d[0]), *const minusY = ir.CreateFNeg(d[1]),
               *const minusZ = ir.CreateFNeg(d[2]);
  const auto choose = [&](Value *ofX, Value *ofY, Value *ofZ) {
    return m_code.select(m_majorZ, ofZ, m_code.select(m_majorX, ofX, ofY));
  };
  const auto bySign = [&](Value *positive, Value *negative) {
    return m_code.select(m_negative, negative, positive);
  };
  return {choose(bySign(minusZ, d[2]), d[0], bySign(d[0], minusX)),
          choose(minusY, bySign(d[2], minusZ), minusY),
          choose(bySign(d[0], minusX), bySign(d[1], minusY), bySign(d[2], minusZ)), nullptr};
}

Vec CubeFace::coordinate() const {
  Vec result = {};
  Value *const half = m_code.splat(0.5f);
  for (std::size_t i = 0; i < 2; ++i)
    result[i] = m_code.ir.CreateFAdd(
        m_code.ir.CreateFMul(m_code.ir.CreateFMul(m_turned[i], m_inverse), half), half);
  return result;
}

Vec CubeFace::derivative(const std::array<Value *, 3> &change) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const Vec changed = turned({change[0], change[1], change[2], nullptr});
  Value *const scale = ir.CreateFMul(m_inverse, m_code.splat(0.5f));
  Vec result = {};
  for (std::size_t i = 0; i < 2; ++i) {
    // (a / m)' = (a' - a / m * m') / m
    Value *const ratio = ir.CreateFMul(m_turned[i], m_inverse);
    Value *const top = ir.CreateFSub(changed[i], ir.CreateFMul(ratio, changed[2]));
    result[i] = ir.CreateFMul(top, scale);
  }
  return result;
}

} // namespace arbiter::fp::llvm_back
