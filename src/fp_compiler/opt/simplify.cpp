#include <algorithm>
#include <bit>
#include <cmath>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/opt/bits.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
bool isPlusZero(std::optional<float> value) {
  return value && std::bit_cast<std::uint32_t>(*value) == 0;
}
bool isMinusZero(std::optional<float> value) {
  return value && *value == 0.0f && std::signbit(*value);
}

class Simplifier {
public:
  Simplifier(const ir::Program &program, Instruction &instruction, Numerics numerics,
             const HeldBits &bits)
      : m_program(program), m_instruction(instruction), m_numerics(numerics), m_bits(bits) {}

  bool run() {
    switch (m_instruction.op) {
    case Opcode::Swz:
      m_instruction.op = Opcode::Mov; // the IR's MOV can select 0 and 1
      return true;
    case Opcode::Mul:
      return product();
    case Opcode::Add: // x + 0 would turn -0 into 0
      return minusZero(1) ? becomeCopy(0) : minusZero(0) && becomeCopy(1);
    case Opcode::Sub:
      return isPlusZero(constant(1)) && becomeCopy(0);
    case Opcode::Mad:
      return multiplyAdd();
    case Opcode::Cmp:
      return compare();
    case Opcode::Max:
    case Opcode::Min:
      return same(0, 1) && becomeCopy(0);
    case Opcode::Pow:
      return constant(1) == 0.0f && becomeOne();
    case Opcode::Abs:
    case Opcode::Rsq:
      return dropSign();
    default:
      return false;
    }
  }

private:
  std::optional<float> constant(int source) const {
    return uniformConstant(m_program, operand(source), ir::operandMask(m_instruction, source),
                           m_numerics);
  }
  const Operand &operand(int source) const { return m_instruction.src[std::size_t(source)]; }
  bool minusZero(int source) const { return isMinusZero(constant(source)); }
  bool same(int a, int b) const {
    return sameReads(operand(a), operand(b), ir::operandMask(m_instruction, a));
  }

  /// Changes the opcode and keeps only the given operands. Returns true.
  bool become(Opcode op, std::initializer_list<int> sources) {
    std::array<Operand, 3> kept = {};
    std::size_t count = 0;
    for (const int source : sources)
      kept[count++] = operand(source);
    m_instruction.src = kept;
    m_instruction.op = op;
    return true;
  }

  /// Replaces an arithmetic instruction by a copy of one operand. Returns false if the operand may
  /// hold raw bits, which a copy would not flush.
  bool becomeCopy(int source) {
    return !m_bits.mayBeIn(operand(source)) && become(Opcode::Mov, {source});
  }

  void negate(int source) { m_instruction.src[std::size_t(source)].negate ^= 0xF; }

  bool becomeOne() {
    Operand one = operand(1);
    one.swizzle.fill(ir::Select::One);
    one.negate = 0;
    one.relative = false;
    m_instruction.src = {one, {}, {}};
    m_instruction.op = Opcode::Mov;
    return true;
  }

  bool product() {
    for (const int source : {0, 1}) {
      const int other = 1 - source;
      const std::optional<float> factor = constant(source);
      if ((factor != 1.0f && factor != -1.0f) || m_bits.mayBeIn(operand(other)))
        continue;
      if (*factor < 0)
        negate(other);
      return become(Opcode::Mov, {other});
    }
    return false;
  }

  bool multiplyAdd() {
    if (minusZero(2))
      return become(Opcode::Mul, {0, 1});
    for (const int source : {0, 1}) {
      const int other = 1 - source;
      const std::optional<float> factor = constant(source);
      if (factor == 1.0f)
        return become(Opcode::Add, {other, 2});
      if (factor == -1.0f)
        return become(Opcode::Sub, {2, other});
    }
    return false;
  }

  bool compare() {
    if (same(1, 2))
      return become(Opcode::Mov, {1});
    bool below = true, notBelow = true;
    for (int i = 0; i < 4; ++i) {
      if (!(m_instruction.dst.mask >> i & 1))
        continue;
      const std::optional<float> value = constantAt(m_program, operand(0), i, m_numerics);
      if (!value)
        return false;
      (*value < 0.0f ? notBelow : below) = false;
    }
    if (below || notBelow)
      return become(Opcode::Mov, {below ? 1 : 2});
    return false;
  }

  bool dropSign() {
    if (operand(0).negate == 0)
      return false;
    m_instruction.src[0].negate = 0;
    return true;
  }

  const ir::Program &m_program;
  Instruction &m_instruction;
  const Numerics m_numerics;
  const HeldBits &m_bits;
};

/// True for a MOV of a register to itself.
bool isIdle(const Instruction &instruction) {
  const Operand &source = instruction.src[0];
  if (instruction.op != Opcode::Mov || instruction.dst.saturate ||
      source.file != instruction.dst.file || source.index != instruction.dst.index)
    return false;
  for (std::size_t i = 0; i < 4; ++i)
    if ((instruction.dst.mask >> i & 1) &&
        (source.swizzle[i] != ir::kIdentity[i] || (source.negate >> i & 1)))
      return false;
  return true;
}

/// True for a KIL whose operand is known not to be negative.
bool isHarmless(const ir::Program &program, const Instruction &instruction, Numerics numerics) {
  if (instruction.op != Opcode::Kil)
    return false;
  for (int i = 0; i < 4; ++i) {
    const std::optional<float> value = constantAt(program, instruction.src[0], i, numerics);
    if (!value || *value < 0.0f)
      return false;
  }
  return true;
}
} // namespace

bool simplify(ir::Program &program, Numerics numerics) {
  bool changed = false;
  const HeldBits bits(program, ir::numericsOf(program.language, numerics));
  for (Instruction &instruction : program.code)
    while (Simplifier(program, instruction, numerics, bits).run())
      changed = true;
  const std::size_t removed = std::erase_if(program.code, [&](const Instruction &instruction) {
    return isIdle(instruction) || isHarmless(program, instruction, numerics);
  });
  return changed || removed != 0;
}

} // namespace arbiter::fp::opt
