#pragma once
#include "fp_compiler/hw/r300/lower/emitter.h"

/// Maps a program's operands to the chip: interpolants, rows of constants, and current registers.
namespace arbiter::fp::hw::r300 {

class Operands {
public:
  Operands(const ir::Program &program, Emitter &emit)
      : m_program(program), m_emit(emit), m_attributes(program.attributes.size()) {}

  /// Returns an operand after swizzle and signs.
  Value read(const ir::Operand &operand);
  /// Returns a constant row that the driver adds.
  Value row(Constant::Kind kind, std::uint16_t index);
  /// Returns an attribute that an option reads: the program's own of that kind, or else \p
  /// otherwise.
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
