#pragma once
#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// What passes ask about values.
namespace arbiter::fp::opt {

/// The number that one component of an operand is known to be, as an instruction reads it: none
/// for a denormal where MOV, SWZ and CMP would read its bits (bits.h).
[[nodiscard]] std::optional<float>
constantAt(const ir::Program &program, const ir::Operand &operand, int position, Numerics numerics);

/// The number that every component in \p mask is, if it is one and the same to the bit.
[[nodiscard]] std::optional<float> uniformConstant(const ir::Program &program,
                                                   const ir::Operand &operand, std::uint8_t mask,
                                                   Numerics numerics);

/// True if both operands name the same register, or the same row by the same address register.
[[nodiscard]] bool sameRegister(const ir::Operand &a, const ir::Operand &b);

/// True if both operands of one instruction read the same values at the positions in \p mask.
[[nodiscard]] bool sameReads(const ir::Operand &a, const ir::Operand &b, std::uint8_t mask);

/// Sets the positions outside \p mask to what the first one in it reads, so that operands that
/// read alike look alike; a scalar's all read its one component. Requires: mask is not 0.
void fillUnused(ir::Operand &operand, std::uint8_t mask);

/// Numbers the successive values of each temporary's components and of each address register; 0 is
/// the initial zero.
class Versions {
public:
  explicit Versions(const ir::Program &program)
      : m_versions(program.temporaries.size(), {0, 0, 0, 0}),
        m_addresses(program.addresses.size(), 0) {}
  [[nodiscard]] std::uint32_t at(std::uint16_t temporary, int component) const {
    return m_versions[temporary][std::size_t(component)];
  }
  [[nodiscard]] std::uint32_t ofAddress(std::uint8_t index) const { return m_addresses[index]; }
  /// Goes past an instruction's write.
  void write(const ir::Instruction &instruction);

private:
  std::vector<std::array<std::uint32_t, 4>> m_versions;
  std::vector<std::uint32_t> m_addresses;
};

/// Finds or appends rows of constants.
class ConstantRows {
public:
  explicit ConstantRows(ir::Program &program);
  /// An operand that reads \p value.
  [[nodiscard]] ir::Operand operand(const ir::Vec4 &value, const Span &span);
  /// False if the table cannot take another row.
  [[nodiscard]] bool hasRoom() const;

private:
  struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 4> &bits) const;
  };
  ir::Program &m_program;
  std::unordered_map<std::array<std::uint32_t, 4>, std::uint16_t, Hash> m_rows;
};

} // namespace arbiter::fp::opt
