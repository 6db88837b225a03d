#pragma once
#include "fp_compiler/hw/r300/lower/operands.h"

/// Finishes a program: applies its options to the results and writes them.
namespace arbiter::fp::hw::r300 {

class Results {
public:
  Results(const ir::Program &program, Flow &flow, Emitter &emit, Operands &operands)
      : m_program(program), m_flow(flow), m_emit(emit), m_operands(operands) {}

  /// Applies the colour sum, then fog.
  void epilogue();
  /// Makes the operations that compute results also write them.
  void outputs();

private:
  [[nodiscard]] bool isColor(std::size_t output) const {
    return m_program.outputs[output].kind == ir::OutputKind::Color;
  }
  [[nodiscard]] Variable outputVariable(std::size_t output) const {
    return Variable(m_program.temporaries.size() + output);
  }
  Value clamped(Variable output, std::uint8_t mask);
  Value fogFactor();
  void fog();
  bool write(const Ref &ref, std::uint8_t target, std::uint8_t component);
  void depthOutput(const Value &value);

  const ir::Program &m_program;
  Flow &m_flow;
  Emitter &m_emit;
  Operands &m_operands;
};

} // namespace arbiter::fp::hw::r300
