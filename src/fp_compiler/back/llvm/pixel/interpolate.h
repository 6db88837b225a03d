#pragma once
#include <array>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// The planes of a primitive as values of the lanes, by the steps of hosts: dx * x is added to c,
/// then dy * (y - originY), and each product and its sum are rounded once (abi::planeAt()) where
/// the processor has an instruction for that, as hosts have it there. Elsewhere hosts round twice.
/// The steps are the same for all lanes; those of Packed find each term in the column of their
/// primitive.
namespace arbiter::fp::llvm_back {

/// Where the code stands: blocks that run once a call, once a group of spans, once an item, and the
/// loop that is written now. What an outer block can compute is put before its terminator.
struct Places {
  llvm::BasicBlock *entry = nullptr;
  llvm::BasicBlock *group = nullptr; ///< null but for Lanes::Row
  llvm::BasicBlock *item = nullptr;
};

/// Writes what \p make makes before the terminator of \p block.
template <typename Make> auto writeIn(Code &code, llvm::BasicBlock *block, Make make) {
  const llvm::IRBuilderBase::InsertPointGuard guard(code.ir);
  code.ir.SetInsertPoint(block->getTerminator());
  return make();
}

class Interpolator {
public:
  /// \param primitive the abi::Primitive, of Lanes::Packed the abi::PrimitiveColumns
  Interpolator(Code &code, const abi::FragmentKey &key, const Places &places, Value *primitive,
               Value *data)
      : m_code(code), m_key(key), m_places(places), m_primitive(primitive), m_data(data) {}

  /// In the item's block: the first pixel, as i32.
  void setPixel(Value *x, Value *y);
  /// In a loop, before anything else is asked for: each lane's pixel relative to the first one, as
  /// i32; `dy` is null where all lanes are of the row.
  void setLanes(Value *dx, Value *dy);
  /// Packed, in the item's block: each lane's column, as i32.
  void setColumns(Value *columns) { m_columns = columns; }

  [[nodiscard]] Vec input(int index, unsigned needed);
  [[nodiscard]] Vec position(const ir::Options &options, unsigned needed);
  /// Window depth, as the plane gives it: abi::depthAt().
  [[nodiscard]] Value *depth();
  /// Where the primitive's back is seen, a mask.
  [[nodiscard]] Value *backFacing();

  // The parts of affine coordinates: scalars of the entry's block. The plane's constant,
  // its dx or dy, the row where it begins as i32, and what Even inputs are multiplied with.
  [[nodiscard]] Value *constant(std::size_t planeOffset);
  [[nodiscard]] Value *slope(std::size_t planeOffset, bool ofY);
  [[nodiscard]] Value *originY();
  [[nodiscard]] Value *evenW();
  [[nodiscard]] static std::size_t planeOf(int input, int component) {
    return offsetof(abi::Primitive, inputs) +
           sizeof(abi::Plane) * std::size_t(4 * input + component);
  }

private:
  [[nodiscard]] Value *scalarField(std::size_t offset);
  [[nodiscard]] Value *scalarInteger(std::size_t offset);
  /// A number or an integer of the primitive, in all lanes, made in the entry's or item's block.
  [[nodiscard]] Value *number(std::size_t offset);
  [[nodiscard]] Value *integer(std::size_t offset);
  [[nodiscard]] Value *inColumns(std::size_t offset);
  [[nodiscard]] Value *plane(std::size_t offset);
  /// a * b + c, rounded once where the processor has an instruction for that, else twice.
  [[nodiscard]] Value *multiplyAdd(Value *a, Value *b, Value *c);
  /// The same, rounded once on any processor.
  [[nodiscard]] Value *fused(Value *a, Value *b, Value *c);
  [[nodiscard]] Value *perspective();
  [[nodiscard]] Value *even();

  Code &m_code;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_primitive, *m_data;
  Value *m_x = nullptr, *m_y = nullptr;
  Value *m_laneX = nullptr, *m_laneY = nullptr; ///< relative to the first pixel
  Value *m_fx = nullptr, *m_fy = nullptr;       ///< relative to where planes begin, floats
  Value *m_w = nullptr;                         ///< 1 / inverseW of this loop
  Value *m_columns = nullptr;                   ///< null but for Packed
};

} // namespace arbiter::fp::llvm_back
