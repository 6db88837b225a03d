#pragma once
#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

#include "fp_compiler/opt/ir_names.h"

/// Helpers of the passes: known constants, versions of registers, rows of constants.
namespace arbiter::fp::opt {

/// Returns the value of one operand component as an instruction reads it, if it is known. It is not
/// known for a denormal in a program with NVIDIA's options, where MOV, SWZ and CMP would copy its
/// bits (bits.h).
[[nodiscard]] std::optional<float>
constantAt(const ir::Program &program, const ir::Operand &operand, int position, Numerics numerics);

/// Returns the value that all components in \p mask have in common to the bit, if there is one.
[[nodiscard]] std::optional<float> uniformConstant(const ir::Program &program,
                                                   const ir::Operand &operand, std::uint8_t mask,
                                                   Numerics numerics);

/// True if both operands name the same register, or the same row by the same address register.
[[nodiscard]] bool sameRegister(const ir::Operand &a, const ir::Operand &b);

/// True if both operands of one instruction read the same values at the positions in \p mask.
[[nodiscard]] bool sameReads(const ir::Operand &a, const ir::Operand &b, std::uint8_t mask);

/// Sets the positions outside \p mask to the first selector inside, so that equal reads compare
/// equal. A scalar's positions all read its one component. Requires: mask is not 0.
void fillUnused(ir::Operand &operand, std::uint8_t mask);

/// Numbers the successive values of each temporary component and address register. 0 is the initial
/// value, zero.
class Versions {
public:
  explicit Versions(const ir::Program &program)
      : m_versions(program.temporaries.size(), {0, 0, 0, 0}),
        m_addresses(program.addresses.size(), 0) {}
  [[nodiscard]] std::uint32_t at(std::uint16_t temporary, int component) const {
    return m_versions[temporary][std::size_t(component)];
  }
  [[nodiscard]] std::uint32_t ofAddress(std::uint8_t index) const { return m_addresses[index]; }
  /// Updates the version of the register that an instruction writes.
  void write(const ir::Instruction &instruction);

private:
  std::vector<std::array<std::uint32_t, 4>> m_versions;
  std::vector<std::uint32_t> m_addresses;
};

/// Finds constant rows in the parameter table, or appends them.
class ConstantRows {
public:
  explicit ConstantRows(ir::Program &program);
  /// Returns an operand that reads \p value, and gives it the \p span. Requires hasRoom().
  [[nodiscard]] ir::Operand operand(const ir::Vec4 &value, const Span &span);
  /// False if the table is full.
  [[nodiscard]] bool hasRoom() const;

private:
  struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 4> &bits) const;
  };
  ir::Program &m_program;
  std::unordered_map<std::array<std::uint32_t, 4>, std::uint16_t, Hash> m_rows;
};

} // namespace arbiter::fp::opt
