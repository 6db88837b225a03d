#include "fp_compiler/analysis/live_values.h"

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::analysis {

using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;

Instruction narrowed(const Instruction &instruction, std::uint8_t written) {
  Instruction result = instruction;
  result.dst.mask = written;
  return result;
}

namespace {
void add(std::vector<std::uint8_t> &to, const std::vector<std::uint8_t> &masks) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] |= masks[i];
}
} // namespace

void add(RegisterMasks &to, const RegisterMasks &masks) {
  add(to.temporaries, masks.temporaries);
  add(to.outputs, masks.outputs);
  add(to.addresses, masks.addresses);
}

namespace {
class Backward {
public:
  explicit Backward(const ir::Program &program) : m_program(program) {
    m_wanted.temporaries.assign(program.temporaries.size(), 0);
    m_wanted.outputs.resize(program.outputs.size());
    m_wanted.addresses.assign(program.addresses.size(), 0);
    for (std::size_t i = 0; i < m_wanted.outputs.size(); ++i)
      m_wanted.outputs[i] = ir::resultMask(program.outputs[i].kind);
    m_live.written.assign(program.code.size(), 0);
    m_live.attributes.assign(program.attributes.size(), 0);
    m_live.parameters.assign(program.parameters.size(), 0);
    m_live.outputs.assign(program.outputs.size(), 0);
  }

  LiveValues run() {
    block(0, m_program.code.size());
    return std::move(m_live);
  }

private:
  /// Visits the instructions of [begin, end) in reverse order.
  void block(std::size_t begin, std::size_t end) {
    for (std::size_t i = end; i-- > begin;) {
      const Instruction &instruction = m_program.code[i];
      if (instruction.op == Opcode::Endrep) {
        const std::size_t start = beginOf(i);
        loop(start, i);
        i = start;
      } else if (instruction.op == Opcode::Brk) {
        add(m_wanted, m_behind.back());
        readOperands(instruction);
        m_live.written[i] = 0xF;
      } else {
        m_live.written[i] |= step(instruction);
      }
    }
  }

  /// Repeats the body until the values live at its end include those live at its start. The masks
  /// only grow. Results of earlier visits therefore stay valid, and nested loops do not start again
  /// from nothing.
  void loop(std::size_t begin, std::size_t end) {
    m_behind.push_back(m_wanted);
    const auto [entry, isNew] = m_live.kept.try_emplace(begin, m_wanted);
    RegisterMasks &kept = entry->second;
    if (!isNew)
      add(kept, m_wanted);
    for (bool grows = true; grows;) {
      m_wanted = kept;
      block(begin + 1, end);
      add(m_wanted, kept);
      grows = m_wanted != kept;
      kept = m_wanted;
    }
    m_behind.pop_back();
    m_live.written[begin] = m_live.written[end] = 0xF;
    readOperands(m_program.code[begin]);
  }

  [[nodiscard]] std::size_t beginOf(std::size_t end) const {
    std::size_t depth = 0;
    for (std::size_t i = end;; --i) {
      depth += m_program.code[i].op == Opcode::Endrep ? 1 : 0;
      if (m_program.code[i].op == Opcode::Rep && --depth == 0)
        return i;
    }
  }

  std::uint8_t step(const Instruction &instruction) {
    const std::uint8_t written = take(instruction);
    if (written != 0)
      readOperands(narrowed(instruction, written));
    return written;
  }

  void readOperands(const Instruction &instruction) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (const std::uint8_t mask = ir::registerMask(instruction, i))
        read(instruction.src[std::size_t(i)], mask);
  }

  /// Returns the destination components that later code reads, and marks them as no longer live.
  std::uint8_t take(const Instruction &instruction) {
    if (ir::info(instruction.op).has(ir::Kills))
      return 0xF;
    const ir::Destination &dst = instruction.dst;
    std::uint8_t &wanted = dst.file == File::Output    ? m_wanted.outputs[dst.index]
                           : dst.file == File::Address ? m_wanted.addresses[dst.index]
                                                       : m_wanted.temporaries[dst.index];
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
      m_wanted.addresses[operand.address] = 1;
      return;
    }
    switch (operand.file) {
    case File::Temporary:
      m_wanted.temporaries[operand.index] |= mask;
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
  RegisterMasks m_wanted;
  std::vector<RegisterMasks> m_behind; ///< for each open loop: the values live after it
  LiveValues m_live;
};
} // namespace

LiveValues liveOf(const ir::Program &program) { return Backward(program).run(); }

} // namespace arbiter::fp::analysis
