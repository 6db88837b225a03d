#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/opt/ir_names.h"

namespace arbiter::fp::opt {

/// Tracks which components of temporaries hold known constants, along straight-line code.
class KnownValues {
public:
  using Components = std::array<std::optional<float>, 4>;

  /// Sets all temporaries to zero, their initial value.
  KnownValues(const ir::Program &program, Numerics numerics);
  void addTemporary() { m_components.emplace_back().fill(0.0f); }

  /// Returns the value of one operand component as an instruction reads it, if it is known.
  [[nodiscard]] std::optional<float> at(const ir::Operand &operand, int position) const;
  /// Returns the known components of an instruction's result.
  [[nodiscard]] Components results(const ir::Instruction &instruction) const;
  void set(const ir::Destination &dst, const Components &values);

private:
  [[nodiscard]] std::optional<float> resultAt(ir::Instruction instruction, int component) const;

  const ir::Program &m_program;
  const Numerics m_numerics;
  std::vector<Components> m_components; ///< by temporary
};

} // namespace arbiter::fp::opt
