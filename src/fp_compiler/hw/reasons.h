#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/hw/native.h"

namespace arbiter::fp::hw {

/// Collects reasons. Reasons with the same resource and text are merged.
class Reasons {
public:
  /// Adds a reason.
  /// \param instruction kNoInstruction (dataflow.h) if the program as a whole causes it
  void add(std::uint32_t ResourceCounts::*resource, std::uint32_t amount, const std::string &text,
           std::uint32_t instruction);
  /// Returns the reasons in the order of NativeReport::reasons, and leaves none.
  [[nodiscard]] std::vector<Reason> take();

private:
  std::vector<Reason> m_reasons;
};

/// Returns the position of a resource in a report.
[[nodiscard]] int resourceOrder(std::uint32_t ResourceCounts::*resource);

/// Returns the name of a temporary in the text, or "t0" if it has none.
[[nodiscard]] std::string nameOf(const ir::Program &program, std::uint16_t temporary);

/// Returns the used components of an operand: ".yxz". Signs and constants that differ are written
/// as in SWZ: ".-x,0,z,1".
[[nodiscard]] std::string swizzleText(const ir::Instruction &instruction, int operand);

/// Returns a text such as "TEX reads R0, which MUL wrote in node 2".
[[nodiscard]] std::string dependencyText(const ir::Program &program, std::uint32_t sample,
                                         std::uint32_t writer, const char *where,
                                         std::uint32_t number);

/// Returns why an opcode takes more than one slot on chips that multiply, add, and have the
/// functions of one component: "SIN is a polynomial". Returns nullptr for other opcodes.
[[nodiscard]] const char *commonExpansionOf(ir::Opcode op);

} // namespace arbiter::fp::hw
