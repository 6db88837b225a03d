#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::opt {

/// Which components of temporaries hold numbers that constants decide, along straight code.
class KnownValues {
public:
  using Components = std::array<std::optional<float>, 4>;

  /// Temporaries begin with zeros.
  KnownValues(const ir::Program &program, Numerics numerics);
  void addTemporary() { m_components.emplace_back().fill(0.0f); }

  /// The number that one component of an operand is known to be, as an instruction reads it.
  [[nodiscard]] std::optional<float> at(const ir::Operand &operand, int position) const;
  /// What an instruction writes, where that is known.
  [[nodiscard]] Components results(const ir::Instruction &instruction) const;
  void set(const ir::Destination &dst, const Components &values);

private:
  [[nodiscard]] std::optional<float> resultAt(ir::Instruction instruction, int component) const;

  const ir::Program &m_program;
  const Numerics m_numerics;
  std::vector<Components> m_components; ///< by temporary
};

} // namespace arbiter::fp::opt
