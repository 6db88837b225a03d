#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "fp_compiler/ir/ir.h"

/// The parts of an instruction, which commas divide, as messages name them.
namespace arbiter::fp {

enum class PartKind : std::uint8_t { Destination, Operand, Selector, Unit, Target };

/// \p number counts operands and selectors from 0.
struct Part {
  PartKind kind;
  int number = 0;
};

/// "first" to "fourth", from 0.
[[nodiscard]] const char *ordinal(int number);

/// "the second operand of ADD", "the texture target of TEX".
[[nodiscard]] std::string partName(ir::Opcode op, Part part);

/// True of the part that stands right behind the opcode.
[[nodiscard]] bool beginsInstruction(ir::Opcode op, Part part);

/// How many parts an instruction has; 0 for one that branches.
[[nodiscard]] int partCount(ir::Opcode op);

/// How an instruction is written: "write ADD dst, a, b;".
/// \param unit how a texture image unit is: "texture[n]"
[[nodiscard]] std::string usageHint(ir::Opcode op, std::string_view unit = "texture[n]");

} // namespace arbiter::fp
