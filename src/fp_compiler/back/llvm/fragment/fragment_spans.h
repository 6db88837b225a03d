#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// Processes several spans at a time, one in each lane. Work that is needed once for each span then
/// costs little more for a group than for one span.
namespace arbiter::fp::llvm_back {

/// Vectors in the group's block with one lane for each span.
class SpanGroup {
public:
  /// Writes the loads of the group's spans, and ends the group's block.
  /// \param items abi::Span
  /// \param first index of the group's first span
  /// \param count number of all spans
  SpanGroup(Code &code, const Places &places, Value *items, Value *first, Value *count);

  /// Returns the number of spans in a group: the doubles of the widest vector.
  [[nodiscard]] unsigned size() const { return unsigned(m_code.lanes) / 2; }
  /// Return the first pixels' window coordinates and the spans' lengths in pixels, as i32 lanes.
  [[nodiscard]] Value *x() const { return m_x; }
  [[nodiscard]] Value *y() const { return m_y; }
  [[nodiscard]] Value *count() const { return m_count; }
  /// Returns a scalar of the entry block or a vector of the group as a vector.
  [[nodiscard]] Value *inLanes(Value *value) const;
  /// Returns, in the item's block, the item's own lane of a vector of numbers or booleans.
  /// \param number the item's index in the group, i32
  [[nodiscard]] Value *ofItem(Value *vector, Value *number) const;

private:
  Code &m_code;
  const Places &m_places;
  Value *m_x, *m_y, *m_count;
};

} // namespace arbiter::fp::llvm_back
