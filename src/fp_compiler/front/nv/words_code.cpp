#include "fp_compiler/front/nv/words_code.h"

namespace arbiter::fp::nv {

namespace {
constexpr std::uint8_t kXyz = 7;

/// Computes X2D: a.xyxy + b.x*c.xzxz + b.y*c.ywyw.
void transform(Code &code, const Instruction &i) {
  const auto [a, b, c] = i.src;
  const Operand first = code.make(
      Opcode::Mad, {component(b, 0), swizzled(c, {Select::X, Select::Z, Select::X, Select::Z}),
                    swizzled(a, {Select::X, Select::Y, Select::X, Select::Y})});
  code.write(Opcode::Mad, i.dst,
             {component(b, 1), swizzled(c, {Select::Y, Select::W, Select::Y, Select::W}), first});
}

/// Computes RFL: 2 (a.d)/(a.a) a - d.
void reflect(Code &code, const Instruction &i) {
  const Operand &axis = i.src[0], &direction = i.src[1];
  const Operand along = code.make(Opcode::Dp3, {axis, direction}, kX);
  const Operand square = code.make(Opcode::Dp3, {axis, axis}, kX);
  const Operand twice = code.make(Opcode::Add, {component(along, 0), component(along, 0)}, kX);
  const Operand inverse = code.make(Opcode::Rcp, {component(square, 0)}, kX);
  const Operand factor = code.make(Opcode::Mul, {component(twice, 0), component(inverse, 0)}, kX);
  code.write(Opcode::Mad, i.dst, {component(factor, 0), axis, negated(direction)});
}

/// Returns the operand with only x and y, so that the third product is zero.
Operand plane(const Operand &operand) {
  return swizzled(operand, {Select::X, Select::Y, Select::Zero, Select::Zero});
}

void dot2Add(Code &code, const Instruction &i) {
  const Operand dot = code.make(Opcode::Dp3, {plane(i.src[0]), plane(i.src[1])}, kX);
  code.write(Opcode::Add, i.dst, {component(dot, 0), component(i.src[2], 0)});
}

void divide(Code &code, const Instruction &i) {
  const Operand inverse = code.make(Opcode::Rcp, {i.src[1]}, kX);
  code.write(Opcode::Mul, i.dst, {i.src[0], component(inverse, 0)});
}

void normalize(Code &code, const Instruction &i) {
  const Operand square = code.make(Opcode::Dp3, {i.src[0], i.src[0]}, kX);
  const Operand inverse = code.make(Opcode::Rsq, {component(square, 0)}, kX);
  code.write(Opcode::Mul, i.dst, {i.src[0], component(inverse, 0)});
}

void sign(Code &code, const Instruction &i) {
  const Operand above = code.make(Opcode::Slt, {zero(), i.src[0]});
  const Operand below = code.make(Opcode::Slt, {i.src[0], zero()});
  code.write(Opcode::Sub, i.dst, {above, below});
}

/// Computes RCC. The result is negative if the smaller of operand and reciprocal is. If one is a
/// zero, whose sign CMP ignores, the other is an infinity.
void clampedReciprocal(Code &code, const Instruction &i) {
  const Operand raw = component(code.make(Opcode::Rcp, {i.src[0]}, kX), 0);
  const Operand lower = code.make(Opcode::Min, {raw, i.src[0]}, kX);
  const Operand size = code.make(Opcode::Abs, {raw}, kX);
  // Clamp to the upper bound first, because MIN turns a NaN into that bound.
  const Operand most = code.make(Opcode::Min, {component(size, 0), code.constant(0x1p64f)}, kX);
  const Operand clamped =
      component(code.make(Opcode::Max, {component(most, 0), code.constant(0x1p-64f)}, kX), 0);
  code.write(Opcode::Cmp, i.dst, {component(lower, 0), negated(clamped), clamped});
}
} // namespace

Operand rounded(Code &code, const Operand &value) {
  const Operand half = code.constant(0.5f);
  const Operand floor = code.make(Opcode::Flr, {value});
  const Operand rest = code.make(Opcode::Sub, {value, floor});
  const Operand above = code.make(Opcode::Slt, {half, rest});
  const Operand tie = code.make(Opcode::Seq, {half, rest});
  const Operand halved = code.make(Opcode::Mul, {floor, half});
  const Operand odd = code.make(Opcode::Slt, {zero(), code.make(Opcode::Frc, {halved})});
  const Operand up = code.make(Opcode::Mad, {tie, odd, above});
  return code.make(Opcode::Add, {floor, up});
}

std::uint8_t writtenBy(const Instruction &instruction) {
  const std::uint8_t mask = instruction.dst.mask;
  if (instruction.op == Opcode::Rfl)
    return mask & kXyz;
  return instruction.op == Opcode::Scs ? std::uint8_t(mask & 3) : mask;
}

void writeInstruction(Code &code, const Instruction &i) {
  switch (i.op) {
  case Opcode::Sgt:
    return code.write(Opcode::Slt, i.dst, {i.src[1], i.src[0]});
  case Opcode::Sle:
    return code.write(Opcode::Sge, i.dst, {i.src[1], i.src[0]});
  case Opcode::Str:
    return code.write(Opcode::Mov, i.dst, {one()});
  case Opcode::Sfl:
    return code.write(Opcode::Mov, i.dst, {zero()});
  case Opcode::X2d:
    return transform(code, i);
  case Opcode::Rfl:
    return reflect(code, i);
  case Opcode::Div:
    return divide(code, i);
  case Opcode::Dp2:
    return code.write(Opcode::Dp3, i.dst, {plane(i.src[0]), plane(i.src[1])});
  case Opcode::Dp2a:
    return dot2Add(code, i);
  case Opcode::Nrm:
    return normalize(code, i);
  case Opcode::Ssg:
    return sign(code, i);
  case Opcode::Rcc:
    return clampedReciprocal(code, i);
  default:
    return code.append(i);
  }
}

} // namespace arbiter::fp::nv
