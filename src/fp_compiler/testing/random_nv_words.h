#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_nv.h"

namespace arbiter::fp::testing {

/// Makes the parts of instructions for randomNvProgram(): operands, conditions, suffixes and
/// destinations. A program has the temporaries r0 to r4 and guard, the array c of parameters, and
/// the constants k, large and small. A vertex program also has the address registers A and B.
class NvWords {
protected:
  NvWords(std::uint64_t seed, const RandomNvOptions &options)
      : m_random(seed), m_options(options) {}

  [[nodiscard]] bool second() const { return m_options.option == ir::NvOption::Second; }
  static std::string number(int value) { return std::to_string(value); }
  std::string temporary() { return "r" + number(m_random.below(kTemporaries)); }
  std::string swizzle(bool scalar);
  std::string attribute();
  std::string address() { return std::string(m_random.chance(50) ? "A" : "B") + swizzle(true); }
  std::string parameter();
  std::string operand(bool scalar);
  /// Returns the operand without signs and bars.
  static std::string bare(std::string value);
  std::string condition();
  /// True if an instruction here may set a condition code.
  [[nodiscard]] bool updatesHere() const { return !m_options.peer || !m_inSubroutine; }
  /// \param saturates set if the suffix is a _SAT or _SSAT
  std::string suffix(const ir::OpInfo &op, bool &saturates);
  /// Returns a destination.
  /// \param op components that it leaves undefined are not written
  std::string destination(ir::Opcode op = ir::Opcode::Mov);

  Random m_random;
  RandomNvOptions m_options;
  int m_counting = 0; ///< how many LOOPs enclose the statement
  bool m_inSubroutine = false;

private:
  static constexpr int kTemporaries = 5;
};

} // namespace arbiter::fp::testing
