#include "apps/tools/advise/flow.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::advise {

using fp::hw::kNoInstruction;

namespace {

/// Returns the kind of a product of two values that are at most affine.
Depends product(Depends a, Depends b) {
  const bool scaled = std::min(a, b) <= Depends::Parameter;
  return scaled ? std::max(a, b) : Depends::Pixel;
}

} // namespace

std::uint8_t componentsRead(const Operand &operand, std::uint8_t mask) {
  std::uint8_t read = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if ((mask >> i & 1) && operand.swizzle[i] <= fp::ir::Select::W)
      read |= std::uint8_t(1 << int(operand.swizzle[i]));
  return read;
}

Flow::Flow(const fp::ir::Program &program)
    : m_program(program), m_dataflow(fp::hw::dataflowOf(program)),
      m_live(fp::analysis::liveOf(program)), m_uses(program.code.size()) {
  collectUses();
  followDependence();
}

void Flow::collectUses() {
  for (std::uint32_t i = 0; i < m_program.code.size(); ++i) {
    if (!live(i))
      continue;
    for (int o = 0; o < operandsOf(m_program.code[i]); ++o) {
      const auto &writers = m_dataflow.writers[i][std::size_t(o)];
      for (std::size_t c = 0; c < 4; ++c)
        if (writers[c] != kNoInstruction &&
            std::find(writers.begin(), writers.begin() + c, writers[c]) == writers.begin() + c)
          m_uses[writers[c]].push_back({i, o});
    }
  }
}

std::optional<std::uint32_t> Flow::writer(std::uint32_t reader, int operand) const {
  const Instruction &instruction = m_program.code[reader];
  const Operand &source = instruction.src[std::size_t(operand)];
  if (source.file != File::Temporary)
    return std::nullopt;
  const std::uint8_t mask = fp::ir::operandMask(instruction, operand);
  std::optional<std::uint32_t> found;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(mask >> c & 1) || source.swizzle[c] > fp::ir::Select::W)
      continue;
    const std::uint32_t writer = m_dataflow.writers[reader][std::size_t(operand)][c];
    if (writer == kNoInstruction || (found && *found != writer))
      return std::nullopt;
    found = writer;
  }
  return found;
}

std::optional<Use> Flow::onlyUse(std::uint32_t index) const {
  return m_uses[index].size() == 1 ? std::optional(m_uses[index][0]) : std::nullopt;
}

bool Flow::readAlone(std::uint32_t index) const {
  return std::all_of(m_uses[index].begin(), m_uses[index].end(),
                     [&](const Use &use) { return writer(use.reader, use.operand) == index; });
}

bool Flow::endsKind(std::uint32_t index) const {
  return m_program.code[index].dst.file != File::Temporary ||
         std::any_of(m_uses[index].begin(), m_uses[index].end(),
                     [&](const Use &use) { return m_depends[use.reader] > m_depends[index]; });
}

Depends Flow::depends(std::uint32_t index, int operand) const { return ofOperand(index, operand); }

Depends Flow::ofOperand(std::uint32_t index, int operand) const {
  const Instruction &instruction = m_program.code[index];
  const Operand &source = instruction.src[std::size_t(operand)];
  switch (source.file) {
  case File::Attribute:
    return Depends::Affine;
  case File::Parameter:
    if (source.relative)
      return Depends::Pixel;
    return m_program.parameters[source.index].kind == fp::ir::ParameterKind::Constant
               ? Depends::Constant
               : Depends::Parameter;
  case File::Temporary:
    break;
  case File::Output:
  case File::Address:
    return Depends::Pixel;
  }
  Depends all = Depends::Constant; // registers without a value are zero
  for (const std::uint32_t writer : m_dataflow.writers[index][std::size_t(operand)])
    if (writer != kNoInstruction)
      all = std::max(all, m_depends[writer]);
  return all;
}

Depends Flow::ofResult(std::uint32_t index) const {
  const Instruction &instruction = m_program.code[index];
  const fp::ir::OpInfo &row = fp::ir::info(instruction.op);
  if (row.has(fp::ir::Kills) || row.has(fp::ir::Texture) || row.has(fp::ir::VertexOnly))
    return Depends::Pixel;
  std::array<Depends, 3> of = {Depends::Constant, Depends::Constant, Depends::Constant};
  for (int o = 0; o < row.operandCount(); ++o)
    of[std::size_t(o)] = ofOperand(index, o);
  const Depends all = std::max({of[0], of[1], of[2]});
  if (all <= Depends::Parameter)
    return all;
  if (instruction.dst.saturate)
    return Depends::Pixel;
  switch (instruction.op) {
  case Opcode::Mov:
  case Opcode::Swz:
  case Opcode::Add:
  case Opcode::Sub:
    return all;
  case Opcode::Mul:
  case Opcode::Dp3:
  case Opcode::Dp4:
  case Opcode::Dph:
    return product(of[0], of[1]);
  case Opcode::Mad:
    return std::max(product(of[0], of[1]), of[2]);
  case Opcode::Lrp:
    return std::max(product(of[0], of[1]), product(of[0], of[2]));
  default:
    return Depends::Pixel;
  }
}

void Flow::followDependence() {
  const std::size_t count = m_program.attributes.size();
  m_depends.assign(m_program.code.size(), Depends::Pixel);
  m_attributes.assign(m_program.code.size(), std::vector<bool>(count));
  for (std::uint32_t i = 0; i < m_program.code.size(); ++i) {
    m_depends[i] = ofResult(i);
    for (int o = 0; o < operandsOf(m_program.code[i]); ++o) {
      const Operand &source = m_program.code[i].src[std::size_t(o)];
      if (source.file == File::Attribute)
        m_attributes[i][source.index] = true;
      for (const std::uint32_t writer : m_dataflow.writers[i][std::size_t(o)])
        for (std::size_t a = 0; writer != kNoInstruction && a < count; ++a)
          m_attributes[i][a] = m_attributes[i][a] || m_attributes[writer][a];
    }
  }
}

bool Flow::holds(const Operand &operand, std::uint8_t mask, std::uint32_t from,
                 std::uint32_t to) const {
  if (operand.file == File::Attribute)
    return true;
  if (operand.file == File::Parameter)
    return !operand.relative; // a relative operand also depends on an address register
  const std::uint8_t read = componentsRead(operand, mask);
  for (std::uint32_t i = from; i < to; ++i) {
    const fp::ir::Destination &dst = m_program.code[i].dst;
    if (dst.file == operand.file && dst.index == operand.index &&
        (fp::ir::writeMask(m_program.code[i]) & read) != 0)
      return false;
  }
  return true;
}

bool Flow::untouched(std::uint16_t temporary, std::uint8_t mask, std::uint32_t first,
                     std::uint32_t last) const {
  for (std::uint32_t i = first; i < last; ++i) {
    const Instruction &instruction = m_program.code[i];
    if (instruction.dst.file == File::Temporary && instruction.dst.index == temporary &&
        (fp::ir::writeMask(instruction) & mask) != 0)
      return false;
    for (int o = 0; o < operandsOf(instruction); ++o)
      if (instruction.src[std::size_t(o)].file == File::Temporary &&
          instruction.src[std::size_t(o)].index == temporary &&
          (fp::ir::registerMask(instruction, o) & mask) != 0)
        return false;
  }
  return true;
}

} // namespace arbiter::tools::advise
