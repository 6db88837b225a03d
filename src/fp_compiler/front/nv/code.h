#pragma once
#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::nv {

/// A whole register as an operand.
[[nodiscard]] ir::Operand registerOf(ir::File file, std::uint16_t index);
/// 0 or 1 in every component; no register is read.
[[nodiscard]] ir::Operand number(ir::Select select);
/// Component x as a write mask, and all four.
inline constexpr std::uint8_t kX = 1, kAll = 0xF;
/// A temporary as an operand; its x, where flags are.
[[nodiscard]] ir::Operand temporary(std::uint16_t index);
[[nodiscard]] ir::Operand flagOf(std::uint16_t index);
/// Components of a temporary, to write.
[[nodiscard]] ir::Destination writtenTo(std::uint16_t index, std::uint8_t mask);
/// An operand's components in another order, each with its sign.
[[nodiscard]] ir::Operand swizzled(const ir::Operand &operand, const ir::Swizzle &swizzle);
[[nodiscard]] ir::Operand component(const ir::Operand &operand, int index);
[[nodiscard]] ir::Operand negated(ir::Operand operand);

/// The code that lowering writes: instructions into the program, and the registers that it needs
/// beside the text's. All that is written stands for the statement that is set.
class Code {
public:
  explicit Code(Binder &binder) : m_binder(binder) {}

  /// What follows is of a statement there, and may use every scratch register again.
  void begin(Span span) {
    m_span = span;
    m_scratchUsed = 0;
  }

  /// A register for the statement alone. Its content is not known.
  [[nodiscard]] ir::Destination scratch(std::uint8_t mask = 0xF);
  /// A register of its own, zero at the start.
  [[nodiscard]] std::uint16_t temporary(std::string_view name);
  [[nodiscard]] ir::Operand constant(float value);

  void write(ir::Opcode op, const ir::Destination &dst,
             std::initializer_list<ir::Operand> operands);
  /// The same into a scratch register, and that.
  [[nodiscard]] ir::Operand make(ir::Opcode op, std::initializer_list<ir::Operand> operands,
                                 std::uint8_t mask = 0xF);
  void append(ir::Instruction instruction);

private:
  Binder &m_binder;
  Span m_span;
  std::vector<std::uint16_t> m_scratch;
  std::size_t m_scratchUsed = 0;
};

} // namespace arbiter::fp::nv
