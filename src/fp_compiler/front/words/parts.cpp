#include "fp_compiler/front/words/parts.h"

#include <iterator>

namespace arbiter::fp {

using ir::Opcode;

namespace {
constexpr int kSelectors = 4; // of SWZ
constexpr const char *kOrdinals[] = {"first", "second", "third", "fourth"};
} // namespace

const char *ordinal(int number) {
  return number >= 0 && number < int(std::size(kOrdinals)) ? kOrdinals[number] : "next";
}

std::string partName(Opcode op, Part part) {
  const ir::OpInfo &row = info(op);
  const std::string of = std::string(" of ") + row.mnemonic;
  switch (part.kind) {
  case PartKind::Destination:
    return "the destination" + of;
  case PartKind::Operand:
    if (row.operandCount() > 1)
      return "the " + std::string(ordinal(part.number)) + " operand" + of;
    return (row.has(ir::Texture) ? "the coordinate" : "the operand") + of;
  case PartKind::Selector:
    return "the " + std::string(ordinal(part.number)) + " selector" + of;
  case PartKind::Unit:
    return "the texture image unit" + of;
  case PartKind::Target:
    return "the texture target" + of;
  }
  return {};
}

bool beginsInstruction(Opcode op, Part part) {
  return part.kind == PartKind::Destination ||
         (part.kind == PartKind::Operand && part.number == 0 && info(op).has(ir::Kills));
}

int partCount(Opcode op) {
  const ir::OpInfo &row = info(op);
  if (row.has(ir::Flow))
    return 0;
  return row.operandCount() + (row.has(ir::Kills) ? 0 : 1) + (row.has(ir::Texture) ? 2 : 0) +
         (op == Opcode::Swz ? kSelectors : 0);
}

std::string usageHint(Opcode op, std::string_view unit) {
  const ir::OpInfo &row = info(op);
  std::string parts;
  const auto add = [&parts](std::string_view part) {
    parts += (parts.empty() ? " " : ", ") + std::string(part);
  };
  if (!row.has(ir::Kills))
    add(op == Opcode::Arl ? "A.x" : "dst");
  for (int i = 0; i < row.operandCount(); ++i)
    add(std::string(1, char('a' + i)) + (row.shapes[i] == 'S' ? ".x" : ""));
  if (op == Opcode::Swz)
    add("x, y, z, w");
  if (row.has(ir::Texture)) {
    add(unit);
    add("2D");
  }
  return std::string("write ") + row.mnemonic + parts + ";";
}

} // namespace arbiter::fp
