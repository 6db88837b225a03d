// Lowers where NVIDIA's own languages differ from its options.

#include <algorithm>

#include "fp_compiler/front/nv/lowerer.h"
#include "fp_compiler/front/nv/words_code.h"

namespace arbiter::fp::nv {

using ir::NativeLanguage;

namespace {
constexpr float kLeastAddress = -512, kMaxAddress = 511;

/// True if the operands have the same value in every component. Nothing may be written between the
/// reads.
bool isSame(const Operand &a, const Operand &b) {
  return a.file == b.file && a.index == b.index && a.swizzle == b.swizzle && a.negate == b.negate &&
         a.relative == b.relative && a.address == b.address && a.offset == b.offset;
}
} // namespace

/// Gives results their initial values. Every result that a vertex program writes starts as
/// (0,0,0,1) and is written in full (NV_vertex_program 2.14.1.5). The options leave it undefined,
/// and NVIDIA's hardware mostly does the same. A written program parameter starts with its value.
/// Results of fragment programs are undefined, and zero here.
void Lowerer::beginResults() {
  for (const Statement &statement : m_statements) {
    const Destination &dst = statement.instruction.dst;
    if (statement.isLabel || !info(statement.instruction.op).hasDestination())
      continue;
    m_code.begin(statement.instruction.span);
    if (statement.indexedResult)
      for (const std::uint16_t output : m_sequences[statement.indexedResult->sequence])
        beginResult(output);
    else if (dst.file == File::Output)
      beginResult(dst.index);
  }
}

void Lowerer::beginResult(std::uint16_t output) {
  if (m_results.contains(output))
    return;
  const Destination target = writtenTo(registerFor(output, kAll), kAll);
  Operand before = number(Select::Zero);
  if (const auto row = m_rules.rows.find(output); row != m_rules.rows.end())
    before = registerOf(File::Parameter, row->second.parameter);
  else if (m_rules.language == NativeLanguage::Fp1)
    return;
  else
    before.swizzle[3] = Select::One;
  m_code.write(Opcode::Mov, target, {before});
}

/// Returns an operand that reads program parameters with the values that the vertex state program
/// wrote.
Operand Lowerer::written(const Operand &operand) {
  if (!operand.relative) {
    for (const auto &[output, row] : m_rules.rows)
      if (row.parameter == operand.index) {
        Operand now = temporary(m_results.at(output).index);
        now.swizzle = operand.swizzle;
        now.negate = operand.negate;
        return now;
      }
    return operand;
  }
  Operand whole = operand;
  whole.swizzle = ir::kIdentity;
  whole.negate = 0;
  const Destination dst = m_code.scratch();
  m_code.write(Opcode::Mov, dst, {whole});
  const Operand address =
      component(temporary(shadowOf(std::uint16_t(operand.address & ~3))), operand.address & 3);
  const Operand is = component(temporary(m_code.scratch(kX).index), 0);
  for (const auto &[output, row] : m_rules.rows) {
    const float wanted = float(row.number) - float(operand.offset);
    m_code.write(Opcode::Seq, writtenTo(is.index, kX), {address, m_code.constant(wanted)});
    m_code.write(Opcode::Cmp, dst,
                 {negated(is), temporary(m_results.at(output).index), temporary(dst.index)});
  }
  Operand now = swizzled(temporary(dst.index), operand.swizzle);
  now.negate = operand.negate;
  return now;
}

/// Returns the value clamped to the range of an address register of !!VP2.0.
Operand Lowerer::kept(const Operand &address) {
  if (m_rules.language != NativeLanguage::Vp2)
    return address;
  const Operand above = m_code.make(Opcode::Max, {address, m_code.constant(kLeastAddress)});
  return m_code.make(Opcode::Min, {above, m_code.constant(kMaxAddress)});
}

/// Writes the instruction's value to its destination, which is a temporary.
void Lowerer::compute(const Statement &statement, const Instruction &instruction) {
  const bool signs =
      m_rules.language == NativeLanguage::Fp1 || m_rules.language == NativeLanguage::Vp2;
  const bool positive = (statement.absolute & 1) != 0 && statement.instruction.src[0].negate == 0;
  if (instruction.op == Opcode::Rsq && signs && !positive && !isSquare(statement))
    return signedRoot(instruction);
  if (instruction.op == Opcode::Pow && m_rules.language == NativeLanguage::Fp1)
    return powerByLogarithm(instruction);
  writeInstruction(m_code, instruction);
}

/// True if the operand is certainly a square, which is not negative and not -0. Its last write must
/// be a product of a value with itself, without a label or jump in between.
bool Lowerer::isSquare(const Statement &statement) const {
  const Operand &operand = statement.instruction.src[0];
  const auto wanted = std::uint8_t(1u << int(operand.swizzle[0]));
  if (operand.file != File::Temporary || operand.negate != 0)
    return false;
  const Statement *at = &statement;
  while (at != m_statements.data()) {
    --at;
    const Instruction &before = at->instruction;
    if (at->isLabel || info(before.op).has(ir::Flow))
      return false;
    if (before.dst.file != File::Temporary || before.dst.index != operand.index ||
        !info(before.op).hasDestination() || (before.dst.mask & wanted) == 0)
      continue;
    const bool product =
        before.op == Opcode::Dp3 || before.op == Opcode::Dp4 || before.op == Opcode::Mul;
    const std::uint8_t bars = at->absolute & 3;
    return product && at->test.rule == Rule::Tr && !at->suffix.signedSaturate &&
           (bars == 0 || bars == 3) && isSame(before.src[0], before.src[1]);
  }
  return false;
}

/// Computes RSQ, which is NaN below zero and -infinity for -0 (NV_fragment_program 3.11.5.27,
/// NV_vertex_program2 2.14.1.10). LG2 gives both of these values, and the reciprocal tells -0 from
/// 0.
void Lowerer::signedRoot(const Instruction &instruction) {
  const Operand &value = instruction.src[0];
  const Operand inverse = component(m_code.make(Opcode::Rcp, {value}, kX), 0);
  const Operand below = component(m_code.make(Opcode::Min, {value, inverse}, kX), 0);
  const Operand undefined = component(m_code.make(Opcode::Lg2, {value}, kX), 0);
  const Operand root = component(m_code.make(Opcode::Rsq, {value}, kX), 0);
  m_code.write(Opcode::Cmp, instruction.dst, {below, undefined, root});
}

/// Computes POW as EX2(b * LG2(a)), with the results of LG2 for zero and below (NV_fragment_program
/// 3.11.5.24).
void Lowerer::powerByLogarithm(const Instruction &instruction) {
  const Operand logarithm = m_code.make(Opcode::Lg2, {instruction.src[0]}, kX);
  const Operand product =
      m_code.make(Opcode::Mul, {component(logarithm, 0), instruction.src[1]}, kX);
  m_code.write(Opcode::Ex2, instruction.dst, {component(product, 0)});
}

} // namespace arbiter::fp::nv
