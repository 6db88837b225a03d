#include "fp_compiler/hw/reasons.h"

#include <algorithm>

#include "fp_compiler/hw/dataflow.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw {

namespace {
constexpr std::uint32_t ResourceCounts::*kOrder[] = {
    &ResourceCounts::instructions,    &ResourceCounts::aluInstructions,
    &ResourceCounts::texInstructions, &ResourceCounts::texIndirections,
    &ResourceCounts::temporaries,     &ResourceCounts::parameters,
    &ResourceCounts::attribs,         &ResourceCounts::addressRegisters};
} // namespace

int resourceOrder(std::uint32_t ResourceCounts::*resource) {
  return int(std::find(std::begin(kOrder), std::end(kOrder), resource) - std::begin(kOrder));
}

void Reasons::add(std::uint32_t ResourceCounts::*resource, std::uint32_t amount,
                  const std::string &text, std::uint32_t instruction) {
  auto found = std::find_if(m_reasons.begin(), m_reasons.end(), [&](const Reason &reason) {
    return reason.resource == resource && reason.text == text;
  });
  if (found == m_reasons.end())
    found = m_reasons.insert(m_reasons.end(), {resource, 0, text, {}});
  found->amount += amount;
  if (instruction != kNoInstruction)
    found->instructions.push_back(instruction);
}

std::vector<Reason> Reasons::take() {
  for (Reason &reason : m_reasons) {
    std::vector<std::uint32_t> &places = reason.instructions;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }
  std::stable_sort(m_reasons.begin(), m_reasons.end(), [](const Reason &a, const Reason &b) {
    const int x = resourceOrder(a.resource), y = resourceOrder(b.resource);
    return x != y ? x < y : a.amount > b.amount;
  });
  return std::move(m_reasons);
}

std::string nameOf(const ir::Program &program, std::uint16_t temporary) {
  const std::string &name =
      temporary < program.temporaries.size() ? program.temporaries[temporary].name : std::string();
  return name.empty() ? "t" + std::to_string(temporary) : name;
}

std::string swizzleText(const ir::Instruction &instruction, int operand) {
  const ir::Operand &source = instruction.src[std::size_t(operand)];
  const std::uint8_t used = operandMask(instruction, operand);
  // If every used component has a sign, it is the operand's sign and not part of the swizzle.
  const bool signs = (source.negate & used) != 0 && (source.negate & used) != used;
  bool numbers = false;
  for (std::size_t c = 0; c < 4; ++c)
    numbers |= (used >> c & 1) && source.swizzle[c] > ir::Select::W;
  std::string text;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(used >> c & 1))
      continue;
    if ((signs || numbers) && !text.empty())
      text += ',';
    if (signs && (source.negate >> c & 1))
      text += '-';
    text += "xyzw01"[int(source.swizzle[c])];
  }
  return "." + text;
}

std::string dependencyText(const ir::Program &program, std::uint32_t sample, std::uint32_t writer,
                           const char *where, std::uint32_t number) {
  const ir::Instruction &instruction = program.code[sample];
  const ir::Operand &coordinate = instruction.src[0];
  return std::string(info(instruction.op).mnemonic) + " reads " +
         (coordinate.file == ir::File::Temporary ? nameOf(program, coordinate.index)
                                                 : "its coordinate") +
         ", which " + info(program.code[writer].op).mnemonic + " wrote in " + where + " " +
         std::to_string(number);
}

const char *commonExpansionOf(ir::Opcode op) {
  switch (op) {
  case ir::Opcode::Sin:
    return "SIN is a polynomial";
  case ir::Opcode::Cos:
    return "COS is a polynomial";
  case ir::Opcode::Scs:
    return "SCS is two polynomials";
  case ir::Opcode::Pow:
    return "POW is LG2, MUL and EX2";
  case ir::Opcode::Xpd:
    return "XPD is a MUL and a MAD";
  case ir::Opcode::Lrp:
    return "LRP is two MAD";
  default:
    return nullptr;
  }
}

} // namespace arbiter::fp::hw
