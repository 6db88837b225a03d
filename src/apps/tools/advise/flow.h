#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "apps/tools/ir_names.h"
#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/hw/dataflow.h"

/// Analyzes the data flow of a program without branches, for rules.
namespace arbiter::tools::advise {

/// The kinds of inputs on which a value depends, as the largest one among its parts. Affine values
/// are sums of texture coordinates multiplied by numbers and parameters; interpolation preserves
/// them.
enum class Depends : std::uint8_t { Constant, Parameter, Affine, Pixel };

/// A read of an instruction's result.
struct Use {
  std::uint32_t reader = 0;
  int operand = 0;
};

[[nodiscard]] inline int operandsOf(const Instruction &instruction) {
  return fp::ir::info(instruction.op).operandCount();
}

class Flow {
public:
  explicit Flow(const fp::ir::Program &program);

  /// Returns the only instruction that wrote the components that an operand reads. Returns nothing
  /// if there are several, or if the operand is no temporary.
  [[nodiscard]] std::optional<std::uint32_t> writer(std::uint32_t reader, int operand) const;
  /// Returns the reads of an instruction's result by live readers.
  [[nodiscard]] const std::vector<Use> &uses(std::uint32_t index) const { return m_uses[index]; }
  /// Returns the read if there is exactly one.
  [[nodiscard]] std::optional<Use> onlyUse(std::uint32_t index) const;
  /// True if readers of the result read no values of other instructions with it.
  [[nodiscard]] bool readAlone(std::uint32_t index) const;
  /// True if a part of the result reaches a program result or a KIL.
  [[nodiscard]] bool live(std::uint32_t index) const { return m_live.written[index] != 0; }
  /// Returns the written components that are live.
  [[nodiscard]] std::uint8_t written(std::uint32_t index) const { return m_live.written[index]; }

  /// Returns the kind of inputs on which an instruction's result depends.
  [[nodiscard]] Depends depends(std::uint32_t index) const { return m_depends[index]; }
  /// True if it is a program result, or if a reader depends on more inputs: it ends a chain of work
  /// of its kind.
  [[nodiscard]] bool endsKind(std::uint32_t index) const;
  /// Returns the kind of inputs on which an operand depends.
  [[nodiscard]] Depends depends(std::uint32_t index, int operand) const;
  /// Returns the attributes on which an instruction's result depends, as bits by index of
  /// Program::attributes.
  [[nodiscard]] const std::vector<bool> &attributes(std::uint32_t index) const {
    return m_attributes[index];
  }

  /// True if the operand has the same value at \p from and at \p to, which comes later or is the
  /// same. That is so if no instruction from \p from on writes the components of its register in \p
  /// mask.
  [[nodiscard]] bool holds(const fp::ir::Operand &operand, std::uint8_t mask, std::uint32_t from,
                           std::uint32_t to) const;
  /// True if no instruction in [first, last) reads or writes these components of the temporary.
  [[nodiscard]] bool untouched(std::uint16_t temporary, std::uint8_t mask, std::uint32_t first,
                               std::uint32_t last) const;

private:
  void collectUses();
  void followDependence();
  [[nodiscard]] Depends ofOperand(std::uint32_t index, int operand) const;
  [[nodiscard]] Depends ofResult(std::uint32_t index) const;

  const fp::ir::Program &m_program;
  fp::hw::Dataflow m_dataflow;
  fp::analysis::LiveValues m_live;
  std::vector<std::vector<Use>> m_uses;
  std::vector<Depends> m_depends;
  std::vector<std::vector<bool>> m_attributes;
};

/// Returns the register components that an operand reads at the positions of \p mask.
[[nodiscard]] std::uint8_t componentsRead(const fp::ir::Operand &operand, std::uint8_t mask);

} // namespace arbiter::tools::advise
