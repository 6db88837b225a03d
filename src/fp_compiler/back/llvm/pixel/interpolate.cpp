#include "fp_compiler/back/llvm/pixel/interpolate.h"

namespace arbiter::fp::llvm_back {

void Interpolator::setPixel(Value *x, Value *y) {
  m_x = x;
  m_y = y;
}

void Interpolator::setLanes(Value *dx, Value *dy) {
  llvm::IRBuilder<> &ir = m_code.ir;
  m_laneX = dx;
  m_laneY = dy;
  m_fx = m_code.toFloat(ir.CreateAdd(m_code.splat(m_x), dx));
  Value *const fromOrigin =
      writeIn(m_code, m_places.item, [&] { return m_code.splat(ir.CreateSub(m_y, originY())); });
  m_fy = dy ? m_code.toFloat(ir.CreateAdd(fromOrigin, dy))
            : writeIn(m_code, m_places.item, [&] { return m_code.toFloat(fromOrigin); });
  m_w = nullptr;
}

/// Returns the primitive's values for the lanes' columns, as i32.
Value *Interpolator::inColumns(std::size_t offset) {
  return writeIn(m_code, m_places.item, [&]() -> Value * {
    llvm::IRBuilder<> &ir = m_code.ir;
    const std::size_t row =
        offsetof(abi::PrimitiveColumns, rows) +
        abi::PrimitiveColumns::rowOf(offset) * sizeof(abi::PrimitiveColumns{}.rows[0]);
    Value *const first = ir.CreateConstInBoundsGEP1_64(ir.getInt8Ty(), m_primitive, row);
    return m_code.lookUp(first, m_columns);
  });
}

Value *Interpolator::number(std::size_t offset) {
  if (m_columns)
    return m_code.ir.CreateBitCast(inColumns(offset), m_code.f32);
  return writeIn(m_code, m_places.entry, [&] { return m_code.splat(scalarField(offset)); });
}

Value *Interpolator::integer(std::size_t offset) {
  if (m_columns)
    return inColumns(offset);
  return writeIn(m_code, m_places.entry, [&] { return m_code.splat(scalarInteger(offset)); });
}

Value *Interpolator::scalarField(std::size_t offset) {
  return writeIn(m_code, m_places.entry,
                 [&] { return m_code.field(m_code.ir.getFloatTy(), m_primitive, offset); });
}

Value *Interpolator::constant(std::size_t planeOffset) {
  return scalarField(planeOffset + offsetof(abi::Plane, c));
}

Value *Interpolator::slope(std::size_t planeOffset, bool ofY) {
  return scalarField(planeOffset + (ofY ? offsetof(abi::Plane, dy) : offsetof(abi::Plane, dx)));
}

Value *Interpolator::originY() {
  return writeIn(m_code, m_places.entry, [&] {
    return m_code.field(m_code.ir.getInt32Ty(), m_data, offsetof(abi::FragmentData, originY));
  });
}

Value *Interpolator::evenW() {
  return writeIn(m_code, m_places.entry, [&] {
    return m_code.ir.CreateFDiv(llvm::ConstantFP::get(m_code.ir.getFloatTy(), 1),
                                constant(offsetof(abi::Primitive, inverseW)));
  });
}

Value *Interpolator::scalarInteger(std::size_t offset) {
  return writeIn(m_code, m_places.entry,
                 [&] { return m_code.field(m_code.ir.getInt32Ty(), m_primitive, offset); });
}

Value *Interpolator::plane(std::size_t offset) {
  Value *const along = multiplyAdd(number(offset + offsetof(abi::Plane, dx)), m_fx,
                                   number(offset + offsetof(abi::Plane, c)));
  return multiplyAdd(number(offset + offsetof(abi::Plane, dy)), m_fy, along);
}

Value *Interpolator::perspective() {
  if (!m_w)
    m_w = m_code.ir.CreateFDiv(m_code.splat(1.0f), plane(offsetof(abi::Primitive, inverseW)));
  return m_w;
}

Value *Interpolator::even() {
  constexpr std::size_t kConstant = offsetof(abi::Primitive, inverseW) + offsetof(abi::Plane, c);
  return writeIn(m_code, m_columns ? m_places.item : m_places.entry, [&] {
    return m_columns ? m_code.ir.CreateFDiv(m_code.splat(1.0f), number(kConstant))
                     : m_code.splat(evenW());
  });
}

Vec Interpolator::input(int index, unsigned needed) {
  Vec values = {};
  const abi::Interpolation how = m_key.inputs[std::size_t(index)];
  for (int c = 0; c < 4; ++c) {
    if (!(needed >> c & 1))
      continue;
    const std::size_t offset = planeOf(index, c);
    Value *&value = values[std::size_t(c)];
    if (how == abi::Interpolation::Flat)
      value = number(offset + offsetof(abi::Plane, c));
    else
      value = plane(offset);
    if (how == abi::Interpolation::Perspective)
      value = m_code.ir.CreateFMul(value, perspective());
    if (how == abi::Interpolation::Even)
      value = m_code.ir.CreateFMul(value, even());
  }
  return values;
}

Vec Interpolator::position(const ir::Options &options, unsigned needed) {
  llvm::IRBuilder<> &ir = m_code.ir;
  // ARB_fragment_coord_conventions: the pixel's centre is at .5 unless the program asks for
  // integers.
  const float centre = options.pixelCenterInteger ? 0.0f : 0.5f;
  Vec values = {};
  if (needed & 1) {
    Value *const x = ir.CreateAdd(m_code.splat(m_x), m_laneX);
    values[0] = ir.CreateFAdd(m_code.toFloat(x), m_code.splat(centre));
  }
  if (needed & 2) {
    Value *y = m_code.splat(m_y);
    if (m_laneY)
      y = ir.CreateAdd(y, m_laneY);
    y = ir.CreateFAdd(m_code.toFloat(y), m_code.splat(centre));
    if (options.originUpperLeft) {
      Value *const height = writeIn(m_code, m_places.entry, [&] {
        return m_code.splat(
            m_code.field(ir.getFloatTy(), m_data, offsetof(abi::FragmentData, windowHeight)));
      });
      // The lowest row's centre is height - 0.5, or height - 1 with integer centres.
      Value *const top =
          options.pixelCenterInteger ? ir.CreateFSub(height, m_code.splat(1.0f)) : height;
      y = ir.CreateFSub(top, y);
    }
    values[1] = y;
  }
  if (needed & 4)
    values[2] = depth();
  if (needed & 8)
    values[3] = plane(offsetof(abi::Primitive, inverseW));
  return values;
}

Value *Interpolator::multiplyAdd(Value *a, Value *b, Value *c) {
  if (m_code.cpu.family != Cpu::Family::Sse41)
    return fused(a, b, c);
  return m_code.ir.CreateFAdd(m_code.ir.CreateFMul(a, b), c);
}

Value *Interpolator::fused(Value *a, Value *b, Value *c) {
  llvm::IRBuilder<> &ir = m_code.ir;
  if (m_code.cpu.family != Cpu::Family::Sse41)
    return ir.CreateIntrinsic(llvm::Intrinsic::fma, {a->getType()}, {a, b, c});
  // llvm.fma would call the library for each lane. Doubles hold the product exactly.
  llvm::Type *const wide = llvm::VectorType::get(
      ir.getDoubleTy(), llvm::cast<llvm::VectorType>(a->getType())->getElementCount());
  const auto widened = [&](Value *value) { return ir.CreateFPExt(value, wide); };
  Value *const sum = ir.CreateFAdd(ir.CreateFMul(widened(a), widened(b)), widened(c));
  return ir.CreateFPTrunc(sum, a->getType());
}

Value *Interpolator::depth() {
  constexpr std::size_t kZ = offsetof(abi::Primitive, z);
  Value *const along = fused(number(kZ + offsetof(abi::DepthPlane, dx)), m_fx,
                             number(kZ + offsetof(abi::DepthPlane, c)));
  Value *const plane = fused(number(kZ + offsetof(abi::DepthPlane, dy)), m_fy, along);
  return m_code.ir.CreateFAdd(plane, number(kZ + offsetof(abi::DepthPlane, offset)));
}

Value *Interpolator::backFacing() {
  return m_code.ir.CreateICmpNE(integer(offsetof(abi::Primitive, backFacing)), m_code.splat(0));
}

} // namespace arbiter::fp::llvm_back
