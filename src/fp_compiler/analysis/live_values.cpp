#include "fp_compiler/analysis/live_values.h"

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::analysis {

using ir::File;
using ir::Instruction;
using ir::Operand;

Instruction narrowed(const Instruction &instruction, std::uint8_t written) {
  Instruction result = instruction;
  result.dst.mask = written;
  return result;
}

namespace {
class Backward {
public:
  explicit Backward(const ir::Program &program)
      : m_program(program), m_temporaries(program.temporaries.size(), 0),
        m_outputs(program.outputs.size()), m_addresses(program.addresses.size(), 0) {
    for (std::size_t i = 0; i < m_outputs.size(); ++i)
      m_outputs[i] = ir::resultMask(program.outputs[i].kind);
    m_live.written.assign(program.code.size(), 0);
    m_live.attributes.assign(program.attributes.size(), 0);
    m_live.parameters.assign(program.parameters.size(), 0);
    m_live.outputs.assign(program.outputs.size(), 0);
  }

  LiveValues run() {
    for (std::size_t i = m_program.code.size(); i-- > 0;)
      m_live.written[i] = step(m_program.code[i]);
    return std::move(m_live);
  }

private:
  std::uint8_t step(const Instruction &instruction) {
    const std::uint8_t written = take(instruction);
    if (written == 0)
      return 0;
    const Instruction part = narrowed(instruction, written);
    for (int i = 0; i < ir::info(part.op).operandCount(); ++i)
      if (const std::uint8_t mask = ir::registerMask(part, i))
        read(part.src[std::size_t(i)], mask);
    return written;
  }

  /// The components of its destination that something reads later; nothing does any more.
  std::uint8_t take(const Instruction &instruction) {
    if (ir::info(instruction.op).has(ir::Kills))
      return 0xF;
    const ir::Destination &dst = instruction.dst;
    std::uint8_t &wanted = dst.file == File::Output    ? m_outputs[dst.index]
                           : dst.file == File::Address ? m_addresses[dst.index]
                                                       : m_temporaries[dst.index];
    if (dst.file == File::Address) {
      const std::uint8_t all = wanted;
      wanted = 0;
      return all;
    }
    const std::uint8_t written = dst.mask & wanted;
    wanted = std::uint8_t(wanted & ~dst.mask);
    if (dst.file == File::Output)
      m_live.outputs[dst.index] |= written;
    return written;
  }

  void read(const Operand &operand, std::uint8_t mask) {
    if (operand.relative) {
      m_addresses[operand.address] = 1;
      return;
    }
    switch (operand.file) {
    case File::Temporary:
      m_temporaries[operand.index] |= mask;
      break;
    case File::Attribute:
      m_live.attributes[operand.index] |= mask;
      break;
    case File::Parameter:
      m_live.parameters[operand.index] |= mask;
      break;
    case File::Output:
    case File::Address:
      break;
    }
  }

  const ir::Program &m_program;
  std::vector<std::uint8_t> m_temporaries, m_outputs, m_addresses;
  LiveValues m_live;
};
} // namespace

LiveValues liveOf(const ir::Program &program) { return Backward(program).run(); }

} // namespace arbiter::fp::analysis
