#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/ir/ir.h"

/// Who computes what from what in a straight-line program: what rules ask.
namespace arbiter::tools::advise {

/// What a value depends on, the largest of its parts. Affine: a sum of products of texture
/// coordinates with numbers and parameters, which interpolation keeps.
enum class Depends : std::uint8_t { Constant, Parameter, Affine, Pixel };

/// A read of an instruction's result.
struct Use {
  std::uint32_t reader = 0;
  int operand = 0;
};

class Flow {
public:
  explicit Flow(const fp::ir::Program &program);

  /// The one instruction that wrote all that operand \p operand of \p reader reads; nothing if
  /// there are several, or if the operand is no temporary.
  [[nodiscard]] std::optional<std::uint32_t> writer(std::uint32_t reader, int operand) const;
  /// The reads of what an instruction writes, by readers that are live.
  [[nodiscard]] const std::vector<Use> &uses(std::uint32_t index) const { return m_uses[index]; }
  /// The read, if it is the only one.
  [[nodiscard]] std::optional<Use> onlyUse(std::uint32_t index) const;
  /// All that the reads of \p index read was written by it.
  [[nodiscard]] bool readAlone(std::uint32_t index) const;
  /// Something of it reaches a result or a KIL.
  [[nodiscard]] bool live(std::uint32_t index) const { return m_live.written[index] != 0; }
  /// Components that count.
  [[nodiscard]] std::uint8_t written(std::uint32_t index) const { return m_live.written[index]; }

  /// What an instruction's result depends on.
  [[nodiscard]] Depends depends(std::uint32_t index) const { return m_depends[index]; }
  /// Something that depends on more reads it, or it is a result: work of its kind ends here.
  [[nodiscard]] bool endsKind(std::uint32_t index) const;
  /// What an operand depends on.
  [[nodiscard]] Depends depends(std::uint32_t index, int operand) const;
  /// The attributes that an instruction's result depends on: bits by index of Program::attributes.
  [[nodiscard]] const std::vector<bool> &attributes(std::uint32_t index) const {
    return m_attributes[index];
  }

  /// The operand of \p from read by an instruction that stands at \p to (later, or the same) gives
  /// the same: no component in \p mask of its register was written meanwhile, \p from itself
  /// included.
  [[nodiscard]] bool holds(const fp::ir::Operand &operand, std::uint8_t mask, std::uint32_t from,
                           std::uint32_t to) const;
  /// No instruction of [first, last) reads or writes any of the components of the temporary.
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

/// Register components that an operand of an instruction reads at the positions of \p mask.
[[nodiscard]] std::uint8_t componentsRead(const fp::ir::Operand &operand, std::uint8_t mask);

} // namespace arbiter::tools::advise
