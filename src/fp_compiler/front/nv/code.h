#pragma once
#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::nv {

// The parts of programs that lowering names most.
using ir::Destination;
using ir::File;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;
using ir::Select;

/// Returns a whole register as an operand.
[[nodiscard]] Operand registerOf(File file, std::uint16_t index);
/// Returns an operand that is 0 or 1 in every component, and reads no register.
[[nodiscard]] Operand number(Select select);
[[nodiscard]] inline Operand zero() { return number(Select::Zero); }
[[nodiscard]] inline Operand one() { return number(Select::One); }
/// The write masks of component x and of all four components.
inline constexpr std::uint8_t kX = 1, kAll = 0xF;
/// Return a temporary as an operand. flagOf() returns its x, which holds a flag.
[[nodiscard]] Operand temporary(std::uint16_t index);
[[nodiscard]] Operand flagOf(std::uint16_t index);
/// Returns a destination: components of a temporary.
[[nodiscard]] Destination writtenTo(std::uint16_t index, std::uint8_t mask);
/// Returns an operand with its components in another order, each with its sign.
[[nodiscard]] Operand swizzled(const Operand &operand, const ir::Swizzle &swizzle);
[[nodiscard]] Operand component(const Operand &operand, int index);
[[nodiscard]] Operand negated(Operand operand);

/// Appends the code that lowering makes, and adds the registers that it needs besides the text's.
/// All code belongs to the current statement.
class Code {
public:
  explicit Code(Binder &binder) : m_binder(binder) {}

  /// Begins a statement. The code that follows belongs to it, and may reuse every scratch register.
  void begin(Span span) {
    m_span = span;
    m_scratchUsed = 0;
  }

  /// Returns a register for the current statement. Its value is undefined.
  [[nodiscard]] Destination scratch(std::uint8_t mask = 0xF);
  /// Adds a register that starts at zero.
  [[nodiscard]] std::uint16_t temporary(std::string_view name);
  [[nodiscard]] Operand constant(float value);

  void write(Opcode op, const Destination &dst, std::initializer_list<Operand> operands);
  /// Writes the instruction to a scratch register, and returns that as an operand.
  [[nodiscard]] Operand make(Opcode op, std::initializer_list<Operand> operands,
                             std::uint8_t mask = 0xF);
  void append(Instruction instruction);

private:
  Binder &m_binder;
  Span m_span;
  std::vector<std::uint16_t> m_scratch;
  std::size_t m_scratchUsed = 0;
};

} // namespace arbiter::fp::nv
