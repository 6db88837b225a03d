#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::testing {

/// A closed range of floats. The rules that compute it are approximate but safe; it keeps random
/// programs' values moderate.
struct Interval {
  float lo = 0, hi = 0;
  [[nodiscard]] float magnitude() const { return std::max(std::fabs(lo), std::fabs(hi)); }
  [[nodiscard]] Interval saturated() const {
    return {std::clamp(lo, 0.0f, 1.0f), std::clamp(hi, 0.0f, 1.0f)};
  }
  Interval operator-() const { return {-hi, -lo}; }
  Interval operator+(const Interval &o) const { return {lo + o.lo, hi + o.hi}; }
  Interval operator*(const Interval &o) const {
    const auto [low, high] = std::minmax({lo * o.lo, lo * o.hi, hi * o.lo, hi * o.hi});
    return {low, high};
  }
};

/// Returns the range of one component of an attribute, within InputRanges.
[[nodiscard]] Interval attributeRange(ir::AttributeKind kind, int component);

/// Returns the range of one component of a vertex attribute. The position is inside the window.
[[nodiscard]] Interval vertexAttributeRange(const ir::Attribute &attribute, int component);

/// Returns the ranges of an arithmetic opcode's result.
[[nodiscard]] std::array<Interval, 4>
rangesOf(ir::Opcode op, const std::array<std::array<Interval, 4>, 3> &operands);

} // namespace arbiter::fp::testing
