#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::ir {

namespace {
constexpr std::uint8_t kX = 1, kY = 2, kZ = 4, kW = 8, kAll = 15;

std::uint8_t litMask(std::uint8_t mask) {
  std::uint8_t reads = 0;
  if (mask & kY)
    reads |= kX;
  if (mask & kZ)
    reads |= kX | kY | kW;
  return reads;
}

std::uint8_t dstMask(std::uint8_t mask, int operand) {
  return operand == 0 ? std::uint8_t(mask & (kY | kZ)) : std::uint8_t(mask & (kY | kW));
}

std::uint8_t crossMask(std::uint8_t mask) {
  std::uint8_t reads = 0;
  if (mask & kX)
    reads |= kY | kZ;
  if (mask & kY)
    reads |= kZ | kX;
  if (mask & kZ)
    reads |= kX | kY;
  return reads;
}

/// Returns the components of a derivative: a comparison's reference has none.
std::uint8_t derivativeMask(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return kX;
  case TexTarget::Tex2D:
  case TexTarget::Rect:
  case TexTarget::Shadow2D:
  case TexTarget::ShadowRect:
    return kX | kY;
  case TexTarget::Tex3D:
  case TexTarget::Cube:
    break;
  }
  return kX | kY | kZ;
}

std::uint8_t textureMask(const Instruction &instruction, int operand) {
  if (operand > 0)
    return derivativeMask(instruction.target);
  std::uint8_t reads = coordinateMask(instruction.target);
  if (instruction.op == Opcode::Txp)
    reads |= kW;
  // A rectangle has one level, so a bias has no effect.
  const bool rectangle =
      instruction.target == TexTarget::Rect || instruction.target == TexTarget::ShadowRect;
  if ((instruction.op == Opcode::Txb || instruction.op == Opcode::Txl) && !rectangle)
    reads |= kW;
  return reads;
}
} // namespace

std::uint8_t coordinateMask(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
    return kX;
  case TexTarget::Tex2D:
  case TexTarget::Rect:
    return kX | kY;
  case TexTarget::Tex3D:
  case TexTarget::Cube:
  case TexTarget::Shadow2D:
  case TexTarget::ShadowRect:
    return kX | kY | kZ;
  case TexTarget::Shadow1D:
    return kX | kZ;
  }
  return 0;
}

std::uint8_t resultMask(OutputKind kind) {
  switch (kind) {
  case OutputKind::Depth:
    return kZ;
  case OutputKind::FogCoord:
  case OutputKind::PointSize:
  case OutputKind::ClipDistance:
    return kX;
  case OutputKind::Color:
  case OutputKind::Position:
  case OutputKind::FrontPrimary:
  case OutputKind::FrontSecondary:
  case OutputKind::BackPrimary:
  case OutputKind::BackSecondary:
  case OutputKind::TexCoord:
  case OutputKind::EnvParameter:
    break;
  }
  return kAll;
}

std::uint8_t writeMask(const Instruction &instruction) {
  return info(instruction.op).hasDestination() ? instruction.dst.mask : 0;
}

std::uint8_t operandMask(const Instruction &instruction, int operand) {
  const OpInfo &row = info(instruction.op);
  if (operand >= row.operandCount())
    return 0;
  if (row.has(Kills))
    return kAll;
  if (row.has(Flow))
    return kX;
  const std::uint8_t mask = instruction.dst.mask;
  if (mask == 0)
    return 0;
  if (row.has(PerComponent))
    return mask;
  if (row.has(Texture))
    return textureMask(instruction, operand);
  if (row.shapes[operand] == 'S')
    return instruction.op == Opcode::Scs && (mask & (kX | kY)) == 0 ? 0 : kX;
  switch (instruction.op) {
  case Opcode::Dp3:
    return kX | kY | kZ;
  case Opcode::Dph:
    return operand == 0 ? std::uint8_t(kX | kY | kZ) : kAll;
  case Opcode::Dst:
    return dstMask(mask, operand);
  case Opcode::Lit:
    return litMask(mask);
  case Opcode::Xpd:
    return crossMask(mask);
  case Opcode::Pk2h:
  case Opcode::Pk2us:
    return kX | kY;
  default:
    return kAll;
  }
}

std::uint8_t registerMask(const Instruction &instruction, int operand) {
  const std::uint8_t reads = operandMask(instruction, operand);
  std::uint8_t mask = 0;
  for (int i = 0; i < 4; ++i) {
    const Select select = instruction.src[std::size_t(operand)].swizzle[std::size_t(i)];
    if ((reads >> i & 1) && select <= Select::W)
      mask |= std::uint8_t(1 << int(select));
  }
  return mask;
}

std::vector<bool> readsUnwritten(const Program &program) {
  std::vector<std::uint8_t> written(program.temporaries.size(), 0);
  std::vector<bool> result(program.temporaries.size(), false);
  if (hasLoops(program)) { // a loop body may not have run
    result.assign(result.size(), true);
    return result;
  }
  for (const Instruction &instruction : program.code) {
    for (int i = 0; i < info(instruction.op).operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      if (operand.file == File::Temporary &&
          (registerMask(instruction, i) & ~written[operand.index]))
        result[operand.index] = true;
    }
    if (writeMask(instruction) && instruction.dst.file == File::Temporary)
      written[instruction.dst.index] |= writeMask(instruction);
  }
  return result;
}

} // namespace arbiter::fp::ir
