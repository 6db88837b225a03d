#pragma once
#include <array>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/ir.h"

/// Evaluates the planes of a primitive in the lanes, with the same steps as hosts. It adds dx * x
/// to c, then dy * (y - originY). Each product and its sum are rounded once if the processor has
/// fused multiply-add (abi::planeAt()), else twice, as hosts do. The steps are the same for all
/// kinds of lanes. Packed lanes look up each coefficient in the column of their primitive.
namespace arbiter::fp::llvm_back {

/// The blocks of the function under construction. They run once for each call, group of spans, or
/// item; the loop is written after them. Loop-invariant code goes before the terminator of an outer
/// block.
struct Places {
  llvm::BasicBlock *entry = nullptr;
  llvm::BasicBlock *group = nullptr; ///< only for Lanes::Row, else null
  llvm::BasicBlock *item = nullptr;
};

/// Calls \p make with the insertion point before the terminator of \p block.
template <typename Make> auto writeIn(Code &code, llvm::BasicBlock *block, Make make) {
  const llvm::IRBuilderBase::InsertPointGuard guard(code.ir);
  code.ir.SetInsertPoint(block->getTerminator());
  return make();
}

class Interpolator {
public:
  /// \param primitive the abi::Primitive; for Lanes::Packed the abi::PrimitiveColumns
  Interpolator(Code &code, const abi::FragmentKey &key, const Places &places, Value *primitive,
               Value *data)
      : m_code(code), m_key(key), m_places(places), m_primitive(primitive), m_data(data) {}

  /// Sets the item's first pixel (i32), in the item's block.
  void setPixel(Value *x, Value *y);
  /// Sets each lane's pixel relative to the first one (i32). It must come first in a loop. `dy` is
  /// null if all lanes are in one row.
  void setLanes(Value *dx, Value *dy);
  /// Packed: sets each lane's column (i32), in the item's block.
  void setColumns(Value *columns) { m_columns = columns; }

  [[nodiscard]] Vec input(int index, unsigned needed);
  [[nodiscard]] Vec position(const ir::Options &options, unsigned needed);
  /// Returns the window depth of the plane: abi::depthAt().
  [[nodiscard]] Value *depth();
  /// Returns a mask: true where the primitive is back-facing.
  [[nodiscard]] Value *backFacing();

  // The following return parts of affine coordinates, as scalars of the entry block: the plane's
  // constant, its dx or dy, its origin row as i32, and the factor of Even inputs.
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
  /// Return a number or an integer of the primitive in all lanes. Its code is in the entry or item
  /// block.
  [[nodiscard]] Value *number(std::size_t offset);
  [[nodiscard]] Value *integer(std::size_t offset);
  [[nodiscard]] Value *inColumns(std::size_t offset);
  [[nodiscard]] Value *plane(std::size_t offset);
  /// Returns a * b + c, rounded once with fused multiply-add, else twice.
  [[nodiscard]] Value *multiplyAdd(Value *a, Value *b, Value *c);
  /// Returns a * b + c, rounded once on any processor.
  [[nodiscard]] Value *fused(Value *a, Value *b, Value *c);
  [[nodiscard]] Value *perspective();
  [[nodiscard]] Value *even();

  Code &m_code;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_primitive, *m_data;
  Value *m_x = nullptr, *m_y = nullptr;
  Value *m_laneX = nullptr, *m_laneY = nullptr; ///< relative to the first pixel
  Value *m_fx = nullptr, *m_fy = nullptr;       ///< relative to the planes' origin, floats
  Value *m_w = nullptr;                         ///< 1 / inverseW in this loop
  Value *m_columns = nullptr;                   ///< only for Packed, else null
};

} // namespace arbiter::fp::llvm_back
