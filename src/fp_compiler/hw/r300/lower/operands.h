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
  /// Returns an attribute that an option of the program reads, such as fog. It is the program's
  /// attribute of that kind. If the program declares none, it is the
  /// interpolant \p otherwise (kFogCoordinate, kSecondaryColor).
  Value attributeOr(ir::AttributeKind kind, std::uint16_t otherwise);

private:
  struct Attribute {
    bool loaded = false;
    Value value;
  };

  Refs position(std::uint16_t attribute);
  /// Returns an attribute, and emits what computes it at the first use only.
  const Value &attribute(std::uint16_t index);
  static Value rowValue(std::uint16_t index);
  Value parameter(std::uint16_t index);
  [[nodiscard]] std::uint16_t attributeOf(ir::AttributeKind kind, std::uint16_t otherwise) const;
  /// Returns an operand's register before swizzle and signs.
  Value whole(const ir::Operand &operand);

  const ir::Program &m_program;
  Emitter &m_emit;
  std::vector<Attribute> m_attributes;
};

} // namespace arbiter::fp::hw::r300
