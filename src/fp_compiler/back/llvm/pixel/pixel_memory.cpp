#include "fp_compiler/back/llvm/pixel/pixel_memory.h"

#include <numeric>
#include <vector>

namespace arbiter::fp::llvm_back {

PixelMemory::PixelMemory(Code &code, const Places &places, Value *data, std::size_t target,
                         int pixelBytes, Value *x, Value *y)
    : m_code(code), m_pixelBytes(pixelBytes) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *base = nullptr;
  writeIn(code, places.entry, [&] {
    base = code.field(ir.getPtrTy(), data, target + offsetof(abi::Target, base));
    m_stride = code.field(ir.getInt64Ty(), data, target + offsetof(abi::Target, rowStride));
  });
  m_first = writeIn(code, places.item, [&] {
    Value *const offset = ir.CreateAdd(
        ir.CreateMul(ir.CreateSExt(y, ir.getInt64Ty()), m_stride),
        ir.CreateMul(ir.CreateSExt(x, ir.getInt64Ty()), ir.getInt64(unsigned(pixelBytes))));
    return ir.CreateGEP(ir.getInt8Ty(), base, offset);
  });
}

Value *PixelMemory::rowPointer(const PixelPlace &place, int row) {
  llvm::IRBuilder<> &ir = m_code.ir;
  if (place.lanes == abi::Lanes::Quad)
    return ir.CreateGEP(ir.getInt8Ty(), m_first,
                        ir.CreateMul(m_stride, ir.getInt64(unsigned(row))));
  Value *const column = ir.CreateSExt(place.column, ir.getInt64Ty());
  return ir.CreateGEP(ir.getInt8Ty(), m_first,
                      ir.CreateMul(column, ir.getInt64(unsigned(m_pixelBytes))));
}

Value *PixelMemory::widened(Value *mask, int parts) {
  if (parts == 1)
    return mask;
  std::vector<int> indices;
  indices.reserve(std::size_t(m_code.lanes * parts));
  for (int i = 0; i < m_code.lanes * parts; ++i)
    indices.push_back(i / parts);
  return m_code.ir.CreateShuffleVector(mask, indices);
}

Value *PixelMemory::slice(Value *vector, int begin, int count) {
  std::vector<int> indices(std::size_t(count), 0);
  std::iota(indices.begin(), indices.end(), begin);
  return m_code.ir.CreateShuffleVector(vector, indices);
}

Value *PixelMemory::joined(Value *a, Value *b) {
  const auto length = [](Value *v) {
    return int(llvm::cast<llvm::FixedVectorType>(v->getType())->getNumElements());
  };
  std::vector<int> indices(std::size_t(length(a) + length(b)), 0);
  std::iota(indices.begin(), indices.end(), 0);
  // Both operands of a shuffle must have the same length.
  std::vector<int> pad(std::size_t(length(a)), -1);
  std::iota(pad.begin(), pad.begin() + length(b), 0);
  return m_code.ir.CreateShuffleVector(a, m_code.ir.CreateShuffleVector(b, pad), indices);
}

Value *PixelMemory::strided(Value *vector, int part, int parts) {
  std::vector<int> indices;
  indices.reserve(std::size_t(m_code.lanes));
  for (int lane = 0; lane < m_code.lanes; ++lane)
    indices.push_back(lane * parts + part);
  return m_code.ir.CreateShuffleVector(vector, indices);
}

Value *PixelMemory::interleaved(Value *vector, Value *lanes, int part, int parts) {
  const int count = m_code.lanes * parts;
  std::vector<int> widen(std::size_t(count), -1), indices;
  std::iota(widen.begin(), widen.begin() + m_code.lanes, 0);
  for (int i = 0; i < count; ++i)
    indices.push_back(i % parts == part ? count + i / parts : i);
  return m_code.ir.CreateShuffleVector(vector, m_code.ir.CreateShuffleVector(lanes, widen),
                                       indices);
}

Value *PixelMemory::lanePointers(const PixelPlace &place, int part, int bytes) {
  llvm::IRBuilder<> &ir = m_code.ir;
  // Offsets from the first pixel fit 32 bits, so that one gather or scatter takes all lanes.
  Value *const stride = m_code.splat(ir.CreateTrunc(m_stride, ir.getInt32Ty()));
  Value *const offset = ir.CreateAdd(ir.CreateMul(place.dy, stride),
                                     ir.CreateMul(place.dx, m_code.splat(m_pixelBytes)));
  Value *const first = ir.CreateConstGEP1_64(ir.getInt8Ty(), m_first, std::uint64_t(part * bytes));
  auto *const wide = llvm::FixedVectorType::get(ir.getInt64Ty(), unsigned(m_code.lanes));
  return ir.CreateGEP(ir.getInt8Ty(), first, ir.CreateSExt(offset, wide));
}

Value *PixelMemory::load(const PixelPlace &place, llvm::Type *type, int parts) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto bytes = int(type->getScalarSizeInBits() / 8);
  const llvm::Align align{std::uint64_t(bytes)};
  if (place.lanes == abi::Lanes::Packed) {
    auto *const lanes = llvm::FixedVectorType::get(type, unsigned(m_code.lanes));
    Value *all =
        llvm::PoisonValue::get(llvm::FixedVectorType::get(type, unsigned(m_code.lanes * parts)));
    for (int part = 0; part < parts; ++part) {
      Value *const some = ir.CreateMaskedGather(lanes, lanePointers(place, part, bytes), align,
                                                place.covered, llvm::Constant::getNullValue(lanes));
      all = parts == 1 ? some : interleaved(all, some, part, parts);
    }
    return all;
  }
  const bool isRow = place.lanes == abi::Lanes::Row;
  const int rows = isRow ? 1 : m_code.cpu.blockHeight();
  const int width = m_code.lanes / rows * parts;
  auto *const vector = llvm::FixedVectorType::get(type, unsigned(width));
  Value *const mask = widened(place.covered, parts);
  Value *all = nullptr;
  for (int row = 0; row < rows; ++row) {
    Value *const some = ir.CreateMaskedLoad(vector, rowPointer(place, row), align,
                                            rows == 1 ? mask : slice(mask, row * width, width),
                                            llvm::Constant::getNullValue(vector));
    all = all ? joined(all, some) : some;
  }
  return all;
}

void PixelMemory::prefetch(const PixelPlace &place) {
  Value *const above = m_code.ir.CreateGEP(m_code.ir.getInt8Ty(), rowPointer(place, 0), m_stride);
  m_code.prefetch(above, unsigned(m_code.lanes * m_pixelBytes), true);
}

void PixelMemory::store(const PixelPlace &place, Value *value, int parts, Value *mask) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto bytes = int(value->getType()->getScalarSizeInBits() / 8);
  const llvm::Align align{std::uint64_t(bytes)};
  if (place.lanes == abi::Lanes::Packed) {
    for (int part = 0; part < parts; ++part)
      ir.CreateMaskedScatter(parts == 1 ? value : strided(value, part, parts),
                             lanePointers(place, part, bytes), align, mask ? mask : place.covered);
    return;
  }
  if (place.lanes == abi::Lanes::Quad) {
    const int rows = m_code.cpu.blockHeight();
    const int width = m_code.lanes / rows * parts;
    Value *const wide = widened(mask ? mask : place.covered, parts);
    for (int row = 0; row < rows; ++row)
      ir.CreateMaskedStore(slice(value, row * width, width), rowPointer(place, row), align,
                           slice(wide, row * width, width));
    return;
  }
  Value *const pointer = rowPointer(place, 0);
  if (mask) {
    ir.CreateMaskedStore(value, pointer, align, widened(mask, parts));
    return;
  }
  // Only a span's last vector may be incomplete.
  llvm::Function *const function = ir.GetInsertBlock()->getParent();
  auto *const whole = llvm::BasicBlock::Create(m_code.context(), "whole", function);
  auto *const tail = llvm::BasicBlock::Create(m_code.context(), "tail", function);
  auto *const done = llvm::BasicBlock::Create(m_code.context(), "stored", function);
  ir.CreateCondBr(ir.CreateICmpSGE(place.remaining, ir.getInt32(unsigned(m_code.lanes))), whole,
                  tail);
  ir.SetInsertPoint(whole);
  ir.CreateAlignedStore(value, pointer, align);
  ir.CreateBr(done);
  ir.SetInsertPoint(tail);
  ir.CreateMaskedStore(value, pointer, align, widened(place.covered, parts));
  ir.CreateBr(done);
  ir.SetInsertPoint(done);
}

} // namespace arbiter::fp::llvm_back
