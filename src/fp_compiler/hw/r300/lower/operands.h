#pragma once
#include "fp_compiler/hw/r300/lower/emitter.h"

/// What a program's operands are on the chip: interpolants, rows, registers as they are now.
namespace arbiter::fp::hw::r300 {

class Operands {
public:
  Operands(const ir::Program &program, Emitter &emit)
      : m_program(program), m_emit(emit), m_attributes(program.attributes.size()) {}

  /// An operand after swizzle and signs.
  Value read(const ir::Operand &operand);
  /// A row of the driver's own.
  Value row(Constant::Kind kind, std::uint16_t index);
  /// What an option reads: the program's attribute of that kind, or \p otherwise.
  Value optional(ir::AttributeKind kind, std::uint16_t otherwise);

private:
  struct Attribute {
    bool loaded = false;
    Value value;
  };

  Refs position(std::uint16_t attribute);
  const Value &attribute(std::uint16_t index);
  static Value rowValue(std::uint16_t index);
  Value parameter(std::uint16_t index);
  [[nodiscard]] std::uint16_t attributeOf(ir::AttributeKind kind, std::uint16_t otherwise) const;
  Value whole(const ir::Operand &operand);

  const ir::Program &m_program;
  Emitter &m_emit;
  std::vector<Attribute> m_attributes;
};

} // namespace arbiter::fp::hw::r300
