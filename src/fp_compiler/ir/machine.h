#pragma once
#include <optional>
#include <vector>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::ir {

/// Runs a program on one fragment or vertex, instruction by instruction, for evaluate().
/// machine.cpp has registers and instructions, machine_flow.cpp loops, and machine_options.cpp fog
/// and colour sum.
class Machine {
public:
  /// Both arguments must outlive the machine.
  Machine(const Program &program, const Inputs &inputs);

  Evaluation run();

  /// Returns the index of the next instruction, or Program::code's size at the end.
  [[nodiscard]] std::size_t at() const { return m_at; }
  /// Runs the next instruction.
  void advance();
  /// Returns the results of the run.
  [[nodiscard]] Evaluation finish();

  /// Operand and result of the next instruction if it is a derivative. Without a result, the
  /// fragment has no neighbours.
  [[nodiscard]] Vec4 operandOf(std::size_t index) const {
    return fetch(m_program.code[index].src[0]);
  }
  void setDerivative(const std::optional<Vec4> &value) { m_derivative = value; }

private:
  struct Loop {
    std::size_t begin = 0;  ///< index of its REP
    std::uint32_t left = 0; ///< iterations that have not begun
  };

  // machine.cpp
  void step(std::size_t index);
  [[nodiscard]] Vec4 read(Vec4 value, AttributeKind kind) const;
  [[nodiscard]] Vec4 given(const Parameter &parameter) const;
  [[nodiscard]] Vec4 resolve(const Parameter &parameter) const;
  [[nodiscard]] Vec4 element(const Operand &operand) const;
  [[nodiscard]] Vec4 fetch(const Operand &operand, bool bits = false) const;
  [[nodiscard]] std::optional<float> levelOf(const Instruction &instruction,
                                             const Vec4 &value) const;
  [[nodiscard]] Sample requestOf(const Instruction &instruction, const Operands &operands) const;
  [[nodiscard]] Vec4 sample(const Sample &request) const;
  [[nodiscard]] Vec4 arithmetic(const Instruction &instruction, const Operands &operands) const;
  [[nodiscard]] Vec4 result(const Instruction &instruction, Step &done) const;
  [[nodiscard]] Vec4 contents(const Destination &dst) const;
  void write(const Destination &dst, const Vec4 &value);

  // machine_flow.cpp
  [[nodiscard]] bool goesOn() const { return !m_evaluation.killed || m_inputs.pastKill; }
  void iterate();
  [[nodiscard]] std::size_t endOf(std::size_t begin) const;

  // machine_options.cpp
  [[nodiscard]] float compute(Opcode op, float a, float b = 0, float c = 0) const;
  [[nodiscard]] float fogFactor() const;
  void colorSum();
  void fog();

  const Program &m_program;
  const Inputs &m_inputs;
  const Numerics m_numerics;
  const bool m_bits; ///< true if registers hold bits, so that moves keep denormals
  std::optional<Vec4> m_derivative;
  std::size_t m_at = 0;
  std::vector<Loop> m_loops;
  std::uint32_t m_begun = 0; ///< iterations begun, of all loops
  std::vector<Vec4> m_temporaries, m_attributes, m_parameters;
  std::vector<std::int32_t> m_addresses;
  Evaluation m_evaluation;
};

} // namespace arbiter::fp::ir
