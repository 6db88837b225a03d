#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "surface.h"

namespace software {

/// A set of the numbers that a component is computed from, a bit each: inputs' components, units'
/// texels. Hosts cancel, and take factors out of, terms that have one in common, before they round;
/// terms that have none they can only add up.
using Leaves = std::uint64_t;
/// Flags beside them: a constant, as hosts add and multiply those of several instructions up
/// beforehand; a product, by one factor of which hosts multiply a constant first; a sum of two
/// products, to the first of which they add a third term; a function's result, as they make one
/// function of several; a number that may be huge, at which a lookup goes wrong.
inline constexpr Leaves kConstant = Leaves(1) << 59, kProduct = Leaves(1) << 60,
                        kProducts = Leaves(1) << 61, kFunction = Leaves(1) << 62,
                        kHuge = Leaves(1) << 63;
inline constexpr Leaves kFlags = kProduct | kProducts | kFunction | kHuge;

struct ExactOperand {
  std::string text;
  std::array<Leaves, 4> leaves = {};
};

/// Each unit has a texture of another target.
inline constexpr int kExactUnits = 5;
inline constexpr int kExactTemporaries = 4;

/// The temporaries of a random program while it is written: the leaves of each component.
class ExactRegisters {
public:
  explicit ExactRegisters(Random &random) : m_random(random) {}

  /// An input in any order. The fog coordinate is its number, as hosts do without products by its
  /// zeros, whose sign is a side of a cube map.
  [[nodiscard]] ExactOperand input();
  /// A temporary or an input, in any order, maybe negated.
  [[nodiscard]] ExactOperand operand();
  /// The same, or constants.
  [[nodiscard]] ExactOperand operandOrConstants();
  /// A component of a temporary or an input.
  [[nodiscard]] ExactOperand scalar();
  /// SWZ's: components of a temporary or an input, zeros and ones, each with its sign.
  [[nodiscard]] ExactOperand selection();
  [[nodiscard]] static ExactOperand texel(int unit);

  /// The temporary that was written last.
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
