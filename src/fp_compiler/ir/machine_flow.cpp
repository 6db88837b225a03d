#include "fp_compiler/ir/machine.h"

namespace arbiter::fp::ir {

Evaluation Machine::run() {
  while (m_at < m_program.code.size() && goesOn())
    advance();
  return finish();
}

void Machine::advance() {
  const Instruction &instruction = m_program.code[m_at];
  if (!info(instruction.op).has(Flow))
    return step(m_at++);
  switch (instruction.op) {
  case Opcode::Rep:
    m_loops.push_back({m_at, iterations(fetch(instruction.src[0])[0])});
    return iterate();
  case Opcode::Endrep:
    return iterate();
  default: // BRK
    if (fetch(instruction.src[0])[0] == 0.0f) {
      ++m_at;
      return;
    }
    m_at = endOf(m_loops.back().begin) + 1;
    m_loops.pop_back();
  }
}

/// Begins the next iteration of the innermost loop, or leaves the loop.
void Machine::iterate() {
  Loop &loop = m_loops.back();
  if (loop.left > 0 && m_begun < kMaxIterations) {
    --loop.left;
    ++m_begun;
    m_at = loop.begin + 1;
    return;
  }
  m_at = endOf(loop.begin) + 1;
  m_loops.pop_back();
}

std::size_t Machine::endOf(std::size_t begin) const {
  std::size_t depth = 0;
  for (std::size_t i = begin;; ++i) {
    depth += m_program.code[i].op == Opcode::Rep ? 1 : 0;
    if (m_program.code[i].op == Opcode::Endrep && --depth == 0)
      return i;
  }
}

Evaluation Machine::finish() {
  if (!goesOn()) {
    m_evaluation.outputs.assign(m_program.outputs.size(), Vec4{});
    m_evaluation.depth.reset();
    return m_evaluation;
  }
  if (m_program.options.colorSum)
    colorSum();
  if (m_program.options.fog != FogMode::None)
    fog();
  return m_evaluation;
}

} // namespace arbiter::fp::ir
