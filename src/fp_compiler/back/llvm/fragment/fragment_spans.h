#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// Spans are looked at some at a time, one in each lane: what must be found out once a span costs
/// little more for all of them than for one.
namespace arbiter::fp::llvm_back {

/// Vectors of the group's block, one lane a span.
class SpanGroup {
public:
  /// Writes the loads of the group's spans, and ends the group's block.
  /// \param items abi::Span; \param first number of the group's first one; \param count of all
  SpanGroup(Code &code, const Places &places, Value *items, Value *first, Value *count);

  /// Spans of a group: doubles of the widest vector.
  [[nodiscard]] unsigned size() const { return unsigned(m_code.lanes) / 2; }
  /// The first pixels' window coordinates and the spans' lengths in pixels: i32 a lane.
  [[nodiscard]] Value *x() const { return m_x; }
  [[nodiscard]] Value *y() const { return m_y; }
  [[nodiscard]] Value *count() const { return m_count; }
  /// A scalar of the entry's block, or a vector of the group's, as a vector.
  [[nodiscard]] Value *inLanes(Value *value) const;
  /// In the item's block: its own lane of a vector of numbers or truths.
  /// \param number the item's in the group, i32
  [[nodiscard]] Value *ofItem(Value *vector, Value *number) const;

private:
  Code &m_code;
  const Places &m_places;
  Value *m_x, *m_y, *m_count;
};

} // namespace arbiter::fp::llvm_back
