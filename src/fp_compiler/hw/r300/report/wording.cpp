#include "fp_compiler/hw/r300/report/wording.h"

#include "fp_compiler/hw/reasons.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::hw::r300 {

namespace {

using ir::Opcode;

/// Returns why an opcode takes more than one slot; nullptr if it should not.
const char *expansionOf(Opcode op) {
  switch (op) {
  case Opcode::Lit:
    return "LIT is LG2, MUL, EX2 and comparisons";
  case Opcode::Flr:
    return "FLR is FRC and a subtraction";
  case Opcode::Dst:
    return "DST writes its components by different operations";
  case Opcode::Sge:
    return "SGE is a subtraction and a comparison";
  case Opcode::Slt:
    return "SLT is a subtraction and a comparison";
  default:
    return commonExpansionOf(op);
  }
}

/// Returns why a coordinate needs a move: it must be a whole register without a swizzle.
std::string coordinateFault(const ir::Program &program, const ir::Instruction &instruction) {
  const ir::Operand &coordinate = instruction.src[0];
  if (coordinate.file == ir::File::Parameter)
    return "is a constant";
  if (coordinate.file == ir::File::Attribute &&
      program.attributes[coordinate.index].kind == ir::AttributeKind::Position)
    return "is fragment.position";
  const std::uint8_t used = operandMask(instruction, 0);
  for (std::size_t c = 0; c < 4; ++c)
    if ((used >> c & 1) && coordinate.swizzle[c] != ir::kIdentity[c])
      return "is swizzled";
  return (coordinate.negate & used) != 0 ? "is negated" : "is not in a plain register";
}

std::string resultFault(const ir::Instruction &instruction) {
  if (isShadow(instruction.target))
    return "is compared";
  if (instruction.dst.saturate)
    return "is saturated";
  if (instruction.dst.file == ir::File::Output)
    return "goes to an output, which no sample can write";
  return "is under a write mask";
}

std::string swizzleFault(const ir::Instruction &instruction) {
  for (int i = 0; i < info(instruction.op).operandCount(); ++i)
    if (!isNative(instruction, i))
      return "swizzle " + swizzleText(instruction, i) + " is not native";
  return "operands in an order that the unit does not have";
}

} // namespace

bool isNative(const ir::Instruction &instruction, int operand) {
  using enum ir::Select;
  static constexpr std::array<ir::Select, 3> kSwizzles[] = {
      {X, Y, Z}, {X, X, X}, {Y, Y, Y}, {Z, Z, Z},          {W, W, W},
      {Y, Z, X}, {Z, X, Y}, {W, Z, Y}, {Zero, Zero, Zero}, {One, One, One}};
  const ir::Operand &source = instruction.src[std::size_t(operand)];
  const std::uint8_t used = operandMask(instruction, operand) & 7u;
  const std::uint8_t signs = source.negate & used;
  if (signs != 0 && signs != used)
    return false;
  for (const auto &native : kSwizzles) {
    bool same = true;
    for (std::size_t c = 0; c < 3; ++c)
      same &= !(used >> c & 1) || native[c] == source.swizzle[c];
    if (same)
      return true;
  }
  return false;
}

std::string aluText(const ir::Program &program, std::uint16_t origin, Cause cause, Extent extent) {
  const bool known = origin != kNone;
  const std::string mnemonic = known ? info(program.code[origin].op).mnemonic : "";
  switch (cause) {
  case Cause::Instruction:
    break;
  case Cause::Swizzle:
    return known ? swizzleFault(program.code[origin]) : "a swizzle is not native";
  case Cause::TextureOperand:
    return known ? "coordinate of " + mnemonic + " " +
                       coordinateFault(program, program.code[origin]) + ": a move"
                 : "a coordinate is moved";
  case Cause::TextureResult:
    return known ? "result of " + mnemonic + " " + resultFault(program.code[origin])
                 : "a sample is moved";
  case Cause::Rectangle:
    return "texels of RECT are scaled to [0,1]";
  case Cause::Position:
    return "fragment.position is computed of the clip position";
  case Cause::Fog:
    return "the fog option is blended in by instructions";
  case Cause::Output:
    return "a result is copied to its register";
  case Cause::EmptyNode:
    return "a node without arithmetic needs an empty slot";
  }
  if (!known)
    return "an option of the program";
  if (extent == Extent::OneSlot)
    return "instructions of one slot";
  if (extent == Extent::HalvesApart)
    return "RGB and alpha of " + mnemonic + " are in different slots";
  const char *expansion = expansionOf(program.code[origin].op);
  return expansion != nullptr ? expansion : mnemonic + " takes more than one operation";
}

std::string constantText(const ir::Program &program, const Constant &constant) {
  const std::string mnemonic =
      constant.origin == kNone ? "" : info(program.code[constant.origin].op).mnemonic;
  switch (constant.kind) {
  case Constant::Kind::Parameter:
    return "the program's own parameters and constants";
  case Constant::Kind::Value:
    return mnemonic.empty() ? "constants of the driver's own"
                            : "a constant of the driver's own for " + mnemonic;
  case Constant::Kind::RectangleScale:
    return "the size of the rectangle texture on unit " + std::to_string(constant.index);
  case Constant::Kind::ViewportScale:
  case Constant::Kind::ViewportOffset:
    return "fragment.position needs the viewport";
  case Constant::Kind::FogColor:
  case Constant::Kind::FogFactors:
    return "the fog option needs the fog's state";
  }
  return {};
}

std::string interpolantName(const ir::Program &program, std::uint16_t attribute) {
  if (attribute == kFogCoordinate)
    return "the fog option's coordinate";
  if (attribute == kSecondaryColor)
    return "the secondary colour that is added";
  return bindingText(program.attributes[attribute]);
}

} // namespace arbiter::fp::hw::r300
