#include "fp_compiler/back/llvm/pixel/pixel_depth.h"

#include <llvm/IR/Intrinsics.h>

namespace arbiter::fp::llvm_back {

void DepthStencil::setPixel(Value *x, Value *y) {
  if (active())
    m_memory.emplace(m_code, m_places, m_data, offsetof(abi::FragmentData, depthStencil),
                     abi::bytesOf(m_key.layout), x, y);
}

Value *DepthStencil::quantised(Value *depth) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto limit = [&](std::size_t offset) {
    return writeIn(m_code, m_places.entry,
                   [&] { return m_code.splat(m_code.field(ir.getFloatTy(), m_data, offset)); });
  };
  Value *const clamped =
      m_code.min(m_code.max(depth, limit(offsetof(abi::FragmentData, depthMinimum))),
                 limit(offsetof(abi::FragmentData, depthMaximum)));
  if (m_key.layout == abi::Layout::Depth32F)
    return clamped;
  if (m_key.layout == abi::Layout::Depth32) { // abi::depth32Of()
    Value *const bits =
        ir.CreateShl(m_code.toInt(ir.CreateFMul(clamped, m_code.splat(0x1p31f))), m_code.splat(1));
    return m_code.select(ir.CreateFCmpOLT(clamped, m_code.splat(1.0f)), bits, m_code.splat(-1));
  }
  // Products of 24 bits are whole numbers from 2^23 on, so rounding to even does not change them.
  const float most = m_key.layout == abi::Layout::Depth16 ? 65535.0f : 16777215.0f;
  Value *const scaled = ir.CreateFMul(clamped, m_code.splat(most));
  return m_code.toInt(ir.CreateUnaryIntrinsic(llvm::Intrinsic::rint, scaled));
}

Value *DepthStencil::passes(Value *incoming, Value *stored) {
  if (m_key.layout != abi::Layout::Depth32)
    return compared(m_code, m_key.depthCompare, incoming, stored);
  // Values are unsigned. Flipping the highest bit gives the same order as signed numbers.
  Value *const sign = m_code.splat(INT32_MIN);
  return compared(m_code, m_key.depthCompare, m_code.ir.CreateXor(incoming, sign),
                  m_code.ir.CreateXor(stored, sign));
}

Value *DepthStencil::ofSide(std::size_t offset) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto at = [&](std::size_t side) {
    return writeIn(m_code, m_places.entry, [&] {
      Value *const byte = m_code.field(ir.getInt8Ty(), m_data, offset + side);
      return m_code.splat(ir.CreateZExt(byte, ir.getInt32Ty()));
    });
  };
  return m_code.select(m_interpolator.backFacing(), at(1), at(0));
}

Value *DepthStencil::operated(abi::StencilOp op, Value *stencil) {
  llvm::IRBuilder<> &ir = m_code.ir;
  Value *const one = m_code.splat(1);
  Value *const byte = m_code.splat(255);
  switch (op) {
  case abi::StencilOp::Keep:
    return stencil;
  case abi::StencilOp::Zero:
    return m_code.splat(0);
  case abi::StencilOp::Replace:
    return ofSide(offsetof(abi::FragmentData, stencilReference));
  case abi::StencilOp::Increment:
    return ir.CreateBinaryIntrinsic(llvm::Intrinsic::umin, ir.CreateAdd(stencil, one), byte);
  case abi::StencilOp::Decrement:
    return ir.CreateBinaryIntrinsic(llvm::Intrinsic::smax, ir.CreateSub(stencil, one),
                                    m_code.splat(0));
  case abi::StencilOp::Invert:
    return ir.CreateXor(stencil, byte);
  case abi::StencilOp::IncrementWrap:
    return ir.CreateAnd(ir.CreateAdd(stencil, one), byte);
  case abi::StencilOp::DecrementWrap:
    return ir.CreateAnd(ir.CreateSub(stencil, one), byte);
  }
  llvm_unreachable("a stencil operation");
}

template <typename Make> Value *DepthStencil::chosen(Make make) {
  Value *const front = make(m_key.front);
  if (m_key.front == m_key.back)
    return front;
  return m_code.select(m_interpolator.backFacing(), make(m_key.back), front);
}

Value *DepthStencil::stored(const PixelPlace &place) {
  llvm::IRBuilder<> &ir = m_code.ir;
  if (m_key.layout == abi::Layout::Depth16)
    return ir.CreateZExt(m_memory->load(place, ir.getInt16Ty(), 1), m_code.i32);
  return m_memory->load(place, ir.getInt32Ty(), 1);
}

Value *DepthStencil::passesStored(Value *incoming, Value *old) {
  if (m_key.layout == abi::Layout::Depth32F)
    return passes(incoming, m_code.ir.CreateBitCast(old, m_code.f32));
  const bool hasStencil = m_key.layout == abi::Layout::Depth24Stencil8;
  return passes(incoming, hasStencil ? m_code.ir.CreateLShr(old, m_code.splat(8)) : old);
}

Value *DepthStencil::mayPass(const PixelPlace &place, Value *depth) {
  return m_code.ir.CreateAnd(place.covered, passesStored(quantised(depth), stored(place)));
}

Value *DepthStencil::test(const PixelPlace &place, Value *depth, Value *mask) {
  llvm::IRBuilder<> &ir = m_code.ir;
  mask = mask ? mask : place.covered;
  const bool isHalf = m_key.layout == abi::Layout::Depth16;
  const bool hasStencil = m_key.layout == abi::Layout::Depth24Stencil8;
  Value *const old = stored(place);
  Value *const yes = llvm::Constant::getAllOnesValue(m_code.i1);
  Value *stencilPass = yes;
  Value *const stencil = hasStencil ? ir.CreateAnd(old, m_code.splat(255)) : nullptr;
  if (testsStencil()) {
    Value *const compareMask = ofSide(offsetof(abi::FragmentData, stencilCompareMask));
    Value *const reference =
        ir.CreateAnd(ofSide(offsetof(abi::FragmentData, stencilReference)), compareMask);
    Value *const value = ir.CreateAnd(stencil, compareMask);
    stencilPass = chosen([&](const abi::StencilFaceKey &face) {
      return compared(m_code, face.compare, reference, value);
    });
  }

  Value *depthPass = yes;
  Value *depthBits = nullptr; ///< depth bits of the whole pixel, without stencil
  if (testsDepth()) {
    Value *const incoming = quantised(depth);
    depthPass = passesStored(incoming, old);
    depthBits = ir.CreateBitCast(incoming, m_code.i32);
    if (hasStencil)
      depthBits = ir.CreateShl(depthBits, m_code.splat(8));
  }

  Value *const lanes = ir.CreateAnd(mask, ir.CreateAnd(stencilPass, depthPass));
  const bool writesDepth = testsDepth() && m_key.depthWrite;
  if (!testsStencil()) {
    if (writesDepth) {
      Value *pixels = depthBits;
      if (hasStencil)
        pixels = ir.CreateOr(pixels, stencil);
      if (isHalf)
        pixels = ir.CreateTrunc(
            pixels, llvm::FixedVectorType::get(ir.getInt16Ty(), unsigned(m_code.lanes)));
      m_memory->store(place, pixels, 1, lanes);
    }
    return lanes;
  }
  Value *made = chosen([&](const abi::StencilFaceKey &face) {
    Value *const afterDepth = m_code.select(depthPass, operated(face.depthPass, stencil),
                                            operated(face.depthFail, stencil));
    return m_code.select(stencilPass, afterDepth, operated(face.fail, stencil));
  });
  Value *const writeMask = ofSide(offsetof(abi::FragmentData, stencilWriteMask));
  made = ir.CreateOr(ir.CreateAnd(made, writeMask), ir.CreateAnd(stencil, ir.CreateNot(writeMask)));
  Value *const oldDepth = ir.CreateAnd(old, m_code.splat(~255));
  Value *const newDepth =
      writesDepth ? m_code.select(ir.CreateAnd(stencilPass, depthPass), depthBits, oldDepth)
                  : oldDepth;
  m_memory->store(place, ir.CreateOr(newDepth, made), 1, mask);
  return lanes;
}

} // namespace arbiter::fp::llvm_back
