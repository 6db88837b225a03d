#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/hw/native.h"

namespace arbiter::fp::hw {

/// Collects reasons: those of one resource with the same text become one.
class Reasons {
public:
  /// \param instruction kNoInstruction (dataflow.h): the program as a whole
  void add(std::uint32_t ResourceCounts::*resource, std::uint32_t amount, const std::string &text,
           std::uint32_t instruction);
  /// In the order of NativeReport::reasons.
  [[nodiscard]] std::vector<Reason> take();

private:
  std::vector<Reason> m_reasons;
};

/// The counts that a report lists, in its order.
[[nodiscard]] int resourceOrder(std::uint32_t ResourceCounts::*resource);

/// "t0", the name in the text, of a temporary.
[[nodiscard]] std::string nameOf(const ir::Program &program, std::uint16_t temporary);

/// ".yxz", the used components of an operand, with signs and constants as SWZ writes them where
/// they are not plain: ".-x,0,z,1".
[[nodiscard]] std::string swizzleText(const ir::Instruction &instruction, int operand);

/// "TEX reads R0, which MUL wrote in node 2"
[[nodiscard]] std::string dependencyText(const ir::Program &program, std::uint32_t sample,
                                         std::uint32_t writer, const char *where,
                                         std::uint32_t number);

} // namespace arbiter::fp::hw
