#pragma once

#include "fp_compiler/hw/slots.h"
#include "fp_compiler/ir/fog.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw {

/// Base of the translations in nv30/ and i915/. It appends slots and counts the attributes and
/// parameters that they read.
class SlotWriter {
public:
  explicit SlotWriter(const ir::Program &program)
      : m_program(program), m_attributes(program.attributes.size(), false),
        m_parameters(program.parameters.size(), false) {
    m_code.gone.assign(program.code.size(), false);
    m_code.slots.reserve(program.code.size() * 2);
  }

protected:
  /// A bit for each operand of an instruction; operand 0 is the lowest bit.
  using Operands = unsigned;
  static constexpr Operands kAll = 7;

  Slot &put(const Slot &slot) {
    m_code.slots.push_back(slot);
    return m_code.slots.back();
  }
  void alu(std::uint16_t origin, SlotCause cause, std::uint32_t count = 1) {
    for (std::uint32_t i = 0; i < count; ++i)
      put({.origin = origin, .cause = cause, .phase = m_phase});
  }

  /// Returns how many different registers of a file the operands read.
  [[nodiscard]] std::uint32_t different(const ir::Instruction &instruction, ir::File file,
                                        Operands among = kAll) const {
    std::uint32_t count = 0;
    for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
      if (!(among >> i & 1) || !reads(instruction, i, file))
        continue;
      bool seen = false;
      for (int j = 0; j < i; ++j)
        seen |= (among >> j & 1) && reads(instruction, j, file) &&
                instruction.src[std::size_t(j)].index == instruction.src[std::size_t(i)].index;
      count += seen ? 0 : 1;
    }
    return count;
  }

  /// True if the operand reads a register of the file.
  [[nodiscard]] static bool reads(const ir::Instruction &instruction, int operand, ir::File file) {
    return instruction.src[std::size_t(operand)].file == file &&
           registerMask(instruction, operand) != 0;
  }

  /// Marks the attributes and parameters of the operands as used.
  void use(const ir::Instruction &instruction) {
    for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      if (reads(instruction, i, ir::File::Attribute))
        m_attributes[operand.index] = true;
      else if (reads(instruction, i, ir::File::Parameter))
        m_parameters[operand.index] = true;
    }
  }

  /// Marks an attribute as used, even if the program does not declare it.
  void useAttribute(ir::AttributeKind kind) {
    for (std::size_t i = 0; i < m_attributes.size(); ++i)
      if (m_program.attributes[i].kind == kind) {
        m_attributes[i] = true;
        return;
      }
    ++m_furtherAttributes;
  }

  void countRows() {
    m_code.attribs = m_furtherAttributes;
    for (std::size_t i = 0; i < m_attributes.size(); ++i) {
      if (!m_attributes[i])
        continue;
      ++m_code.attribs;
      const ir::AttributeKind kind = m_program.attributes[i].kind;
      if (kind == ir::AttributeKind::TexCoord || kind == ir::AttributeKind::Position)
        ++m_code.interpolators;
    }
    m_code.parameters = m_code.ownConstants;
    for (const bool used : m_parameters)
      m_code.parameters += used ? 1 : 0;
  }

  /// Adds the colour sum's slot and the fog factor's, with the two rows of state that fog reads.
  /// Returns true if fog is to be blended in.
  bool addOptions() {
    if (!writesColor())
      return false;
    if (m_program.options.colorSum) {
      alu(kWholeProgram, SlotCause::ColorSum);
      useAttribute(ir::AttributeKind::ColorSecondary);
    }
    if (m_program.options.fog == ir::FogMode::None)
      return false;
    alu(kWholeProgram, SlotCause::Fog, ir::rowOf(m_program.options.fog).instructions);
    useAttribute(ir::AttributeKind::FogCoord);
    m_code.ownConstants += 2;
    return true;
  }

private:
  /// True if the program writes result.color, which fog is blended into.
  [[nodiscard]] bool writesColor() const {
    for (const ir::Output &output : m_program.outputs)
      if (output.kind == ir::OutputKind::Color && output.index == 0)
        return true;
    return false;
  }

protected:
  const ir::Program &m_program;
  SlotProgram m_code;
  std::uint32_t m_phase = 0;

private:
  std::vector<bool> m_attributes, m_parameters;
  std::uint32_t m_furtherAttributes = 0;
};

} // namespace arbiter::fp::hw
