#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "surface.h"

namespace software {

/// The set of numbers that a component is computed from, one bit each: components of inputs, texels
/// of units. Before rounding, hosts cancel terms with a common factor, or factor it out. Terms
/// without one can only be added.
using Leaves = std::uint64_t;
/// Flags beside them. kConstant: hosts precompute sums and products of constants of several
/// instructions. kProduct: hosts first multiply a constant by one factor of a product. kProducts: a
/// sum of two products, to the first of which hosts add a third term. kFunction: hosts merge
/// several functions into one. kHuge: the number may be too large for a lookup.
inline constexpr Leaves kConstant = Leaves(1) << 59, kProduct = Leaves(1) << 60,
                        kProducts = Leaves(1) << 61, kFunction = Leaves(1) << 62,
                        kHuge = Leaves(1) << 63;
inline constexpr Leaves kFlags = kProduct | kProducts | kFunction | kHuge;

struct ExactOperand {
  std::string text;
  std::array<Leaves, 4> leaves = {};
};

/// The number of units, each with a texture of another target.
inline constexpr int kExactUnits = 5;
inline constexpr int kExactTemporaries = 4;

/// Tracks the temporaries of a random program while it is written: the leaves of each component.
class ExactRegisters {
public:
  explicit ExactRegisters(Random &random) : m_random(random) {}

  /// Returns an input in any order. The fog coordinate is used as a scalar, as hosts omit products
  /// with its zeros, whose sign selects a side of a cube map.
  [[nodiscard]] ExactOperand input();
  /// Returns a temporary or an input, in any order, possibly negated.
  [[nodiscard]] ExactOperand operand();
  /// Returns an operand, or constants.
  [[nodiscard]] ExactOperand operandOrConstants();
  /// Returns a component of a temporary or an input.
  [[nodiscard]] ExactOperand scalar();
  /// Returns an operand for SWZ: components of a temporary or an input, zeros and ones, each with a
  /// sign.
  [[nodiscard]] ExactOperand selection();
  [[nodiscard]] static ExactOperand texel(int unit);

  /// Returns the last written temporary.
  [[nodiscard]] int last() const { return m_last; }
  void write(int temporary, unsigned mask, const std::array<Leaves, 4> &leaves);

private:
  int temporary();
  ExactOperand whole();
  ExactOperand ordered(const std::string &name, const std::array<Leaves, 4> &leaves);

  Random &m_random;
  std::array<std::array<Leaves, 4>, kExactTemporaries> m_temporaries = {};
  int m_last = 0;
};

} // namespace software
