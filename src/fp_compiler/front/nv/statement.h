#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/ir/ir.h"

/// The parsed statements of programs under NVIDIA's options, before they are lowered to the IR.
namespace arbiter::fp::nv {

/// A test of a condition code register. Component i of the test is component swizzle[i] of the
/// register.
struct Test {
  Rule rule = Rule::Tr;
  std::uint8_t condition = 0; ///< CC0 or CC1
  ir::Swizzle swizzle = ir::kIdentity;
};

/// An attribute or result that an address register selects from a sequence, at address + offset. In
/// fragment programs the address is A0, the index of the innermost LOOP.
struct Indexed {
  std::uint16_t sequence = 0; ///< into Sequences
  std::uint8_t address = 0;   ///< of Program::addresses; not used in fragment programs
  std::int16_t offset = 0;
};
/// Rows of Program::attributes or Program::outputs, by index.
using Sequences = std::vector<std::vector<std::uint16_t>>;

inline constexpr std::uint16_t kNoLabel = std::numeric_limits<std::uint16_t>::max();

/// A statement. A label is a statement without an opcode; it names the place of the next one.
struct Statement {
  /// Its opcode may be one that the front end lowers to others (FP_NV_WORD in ops.def). An address
  /// register is four times its number.
  ir::Instruction instruction;
  std::uint8_t absolute = 0; ///< bit i: operand i is within bars; its sign is before them
  std::array<std::optional<Indexed>, 3> indexed; ///< of operands, whose index says nothing then
  std::optional<Indexed> indexedResult;          ///< likewise of the destination
  Test test;                                     ///< of the write, of KIL, of a branch
  bool tests = false;                            ///< KIL has the test and no operand
  NvSuffix suffix;
  bool isLabel = false;
  std::uint16_t label = kNoLabel; ///< of a label, BRA and CAL: which
};

} // namespace arbiter::fp::nv
