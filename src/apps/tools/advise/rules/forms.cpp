#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/values.h"

/// Finds instructions that another one can include (MAD, LRP), and operands without an effect.
namespace arbiter::tools::advise {

namespace {

bool adds(Opcode op) { return op == Opcode::Add || op == Opcode::Sub; }

/// Returns the operand of \p inner as \p outer would read it directly.
std::optional<std::string> through(const Subject &subject, std::uint32_t outer, int outerOperand,
                                   std::uint32_t inner, int innerOperand, bool negative) {
  const std::uint8_t mask = subject.at(outer).dst.mask;
  Operand read = subject.at(outer).src[std::size_t(outerOperand)];
  read.negate = 0;
  read = composed(read, subject.at(inner).src[std::size_t(innerOperand)]);
  if (negative)
    read.negate = std::uint8_t(read.negate ^ 0xF);
  if (!subject.flow().holds(read, mask, inner, outer))
    return std::nullopt;
  return Subject::spelled(subject.base(inner, innerOperand), read, mask, false);
}

std::optional<std::string> plain(const Subject &subject, std::uint32_t index, int operand,
                                 bool negative = false) {
  Operand read = subject.at(index).src[std::size_t(operand)];
  if (negative)
    read.negate = std::uint8_t(read.negate ^ 0xF);
  return Subject::spelled(subject.base(index, operand), read, subject.at(index).dst.mask, false);
}

/// Returns the operand's sign if it is the same at all positions that count; true for negative.
std::optional<bool> signOf(const Subject &subject, std::uint32_t index, int operand) {
  const std::uint8_t mask = fp::ir::operandMask(subject.at(index), operand);
  const std::uint8_t signs = subject.at(index).src[std::size_t(operand)].negate & mask;
  if (signs != 0 && signs != mask)
    return std::nullopt;
  return signs != 0;
}

void proposeMultiplyAdd(const Subject &subject, std::uint32_t sum, int operand,
                        Proposals &proposals) {
  const auto product = subject.flow().writer(sum, operand);
  const auto sign = signOf(subject, sum, operand);
  if (!product || !sign || subject.at(*product).op != Opcode::Mul ||
      subject.at(*product).dst.saturate)
    return;
  const bool subtracts = subject.at(sum).op == Opcode::Sub;
  const bool negative = *sign != (subtracts && operand == 1);
  const auto a = through(subject, sum, operand, *product, 0, negative);
  const auto b = through(subject, sum, operand, *product, 1, false);
  const auto c = plain(subject, sum, 1 - operand, subtracts && operand == 0);
  if (!a || !b || !c)
    return;
  Draft draft(subject);
  draft.replace(sum, statementText(Opcode::Mad, subject.at(sum).dst.saturate,
                                   subject.destination(sum), {*a, *b, *c}));
  proposals.push_back(draft.about(*product, sum, "multiply_add",
                                  std::string("MUL and ") +
                                      fp::ir::info(subject.at(sum).op).mnemonic + " are one MAD"));
}

/// Proposes LRP for SUB d, b, c; MAD r, a, d, c.
void proposeBlend(const Subject &subject, std::uint32_t mad, int operand, Proposals &proposals) {
  const auto difference = subject.flow().writer(mad, operand);
  if (!difference || subject.at(*difference).op != Opcode::Sub ||
      subject.at(*difference).dst.saturate || signOf(subject, mad, operand) != false)
    return;
  const auto weight = plain(subject, mad, 1 - operand), to = plain(subject, mad, 2);
  const auto from = through(subject, mad, operand, *difference, 0, false);
  const auto base = through(subject, mad, operand, *difference, 1, false);
  if (!weight || !to || !from || base != to)
    return;
  Draft draft(subject);
  draft.replace(mad, statementText(Opcode::Lrp, subject.at(mad).dst.saturate,
                                   subject.destination(mad), {*weight, *from, *to}));
  proposals.push_back(
      draft.about(*difference, mad, "linear_blend", "SUB and MAD are one LRP", Nearness::Rounding));
}

/// Proposes LRP for SUB d, 1, a; MUL t, d, c; MAD r, a, b, t.
void proposeWeights(const Subject &subject, std::uint32_t mad, Proposals &proposals) {
  const auto product = subject.flow().writer(mad, 2);
  if (!product || subject.at(*product).op != Opcode::Mul || subject.at(*product).dst.saturate ||
      signOf(subject, mad, 2) != false)
    return;
  for (const int o : {0, 1}) {
    const auto rest = subject.flow().writer(*product, o);
    if (!rest || subject.at(*rest).op != Opcode::Sub || subject.number(*rest, 0) != 1.0f ||
        signOf(subject, *product, o) != false)
      continue;
    const auto to = through(subject, mad, 2, *product, 1 - o, false);
    for (const int w : {0, 1}) {
      const auto weight = plain(subject, mad, w), from = plain(subject, mad, 1 - w);
      if (!weight || !from || !to)
        continue;
      Draft draft(subject);
      draft.replace(mad, statementText(Opcode::Lrp, subject.at(mad).dst.saturate,
                                       subject.destination(mad), {*weight, *from, *to}));
      proposals.push_back(draft.about(*rest, mad, "linear_blend",
                                      "a weight and 1 minus it are one LRP", Nearness::Rounding));
    }
  }
}

/// Proposes DPH for DP3 t, a, b; ADD r, t, b.w.
void proposeHomogeneous(const Subject &subject, std::uint32_t sum, int operand,
                        Proposals &proposals) {
  const auto dot = subject.flow().writer(sum, operand);
  if (!dot || subject.at(sum).op != Opcode::Add || subject.at(*dot).op != Opcode::Dp3 ||
      subject.at(*dot).dst.saturate || signOf(subject, sum, operand) != false)
    return;
  const Operand &last = subject.at(sum).src[std::size_t(1 - operand)];
  const std::uint8_t mask = subject.at(sum).dst.mask;
  for (const int o : {0, 1}) {
    Operand whole = subject.at(*dot).src[std::size_t(o)];
    const std::uint8_t read = componentsRead(last, mask);
    if (!fp::opt::sameRegister(whole, last) || (read & (read - 1)) != 0 || read == 0)
      continue;
    std::size_t at = 0;
    while (!(mask >> at & 1))
      ++at;
    whole.swizzle[3] = last.swizzle[at];
    whole.negate = std::uint8_t((whole.negate & 7) | (last.negate >> at & 1 ? 8 : 0));
    const auto a = subject.spelled(*dot, 1 - o, 7, false);
    const auto b = Subject::spelled(subject.base(*dot, o), whole, 0xF, false);
    if (!a || !b || !subject.flow().holds(whole, 0xF, *dot, sum) ||
        !subject.flow().holds(subject.at(*dot).src[std::size_t(1 - o)], 7, *dot, sum))
      continue;
    Draft draft(subject);
    draft.replace(sum, statementText(Opcode::Dph, subject.at(sum).dst.saturate,
                                     subject.destination(sum), {*a, *b}));
    proposals.push_back(draft.about(*dot, sum, "homogeneous_dot_product",
                                    "DP3 and the w that is added are one DPH", Nearness::Rounding));
  }
}

void proposeStatement(const Subject &subject, std::uint32_t index, Opcode op,
                      const std::vector<std::optional<std::string>> &operands, const char *message,
                      Proposals &proposals) {
  std::vector<std::string> texts;
  for (const auto &operand : operands) {
    if (!operand)
      return;
    texts.push_back(*operand);
  }
  Draft draft(subject);
  draft.replace(
      index, statementText(op, subject.at(index).dst.saturate, subject.destination(index), texts));
  proposals.push_back(draft.about(index, "operand_without_effect", message));
}

void proposeIdentity(const Subject &subject, std::uint32_t i, Proposals &proposals) {
  const Opcode op = subject.at(i).op;
  const auto at = [&](int operand, bool negative = false) {
    return plain(subject, i, operand, negative);
  };
  for (const int o : {0, 1}) {
    const auto number = subject.number(i, o);
    if (op == Opcode::Add && number == 0.0f)
      proposeStatement(subject, i, Opcode::Mov, {at(1 - o)}, "adds 0", proposals);
    if (op == Opcode::Mul && number == 1.0f)
      proposeStatement(subject, i, Opcode::Mov, {at(1 - o)}, "multiplies by 1", proposals);
    if (op == Opcode::Mul && number == -1.0f)
      proposeStatement(subject, i, Opcode::Mov, {at(1 - o, true)},
                       "multiplies by -1: any operand takes a sign", proposals);
    if (op == Opcode::Mad && number == 1.0f)
      proposeStatement(subject, i, Opcode::Add, {at(1 - o), at(2)}, "multiplies by 1", proposals);
    if ((op == Opcode::Max || op == Opcode::Min) && o == 0 && at(0) && at(0) == at(1))
      proposeStatement(subject, i, Opcode::Mov, {at(0)}, "compares a value with itself", proposals);
  }
  if (op == Opcode::Sub && subject.number(i, 1) == 0.0f)
    proposeStatement(subject, i, Opcode::Mov, {at(0)}, "subtracts 0", proposals);
  if (op == Opcode::Mad && subject.number(i, 2) == 0.0f)
    proposeStatement(subject, i, Opcode::Mul, {at(0), at(1)}, "adds 0", proposals);
  if (op == Opcode::Lrp && subject.number(i, 0) == 1.0f)
    proposeStatement(subject, i, Opcode::Mov, {at(1)}, "blends with weight 1", proposals);
  if (op == Opcode::Lrp && subject.number(i, 0) == 0.0f)
    proposeStatement(subject, i, Opcode::Mov, {at(2)}, "blends with weight 0", proposals);
}

/// Proposes to remove ABS before RSQ, which takes the magnitude itself.
void proposeMagnitude(const Subject &subject, std::uint32_t i, Proposals &proposals) {
  if (subject.at(i).op != Opcode::Rsq)
    return;
  const auto magnitude = subject.flow().writer(i, 0);
  if (!magnitude || subject.at(*magnitude).op != Opcode::Abs || subject.at(*magnitude).dst.saturate)
    return;
  Operand read = subject.at(i).src[0];
  read = composed(read, subject.at(*magnitude).src[0]);
  read.negate = 0;
  const auto text = Subject::spelled(subject.base(*magnitude, 0), read, 1, true);
  if (!text || !subject.flow().holds(read, 1, *magnitude, i))
    return;
  Draft draft(subject);
  draft.replaceOperand(i, 0, *text);
  proposals.push_back(draft.about(*magnitude, i, "operand_without_effect",
                                  "RSQ takes its operand's magnitude by itself"));
}

} // namespace

Proposals multiplyAdd(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (int o = 0; o < 2 && adds(subject.at(i).op); ++o)
      proposeMultiplyAdd(subject, i, o, proposals);
  return proposals;
}

Proposals homogeneousProducts(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (const int o : {0, 1})
      proposeHomogeneous(subject, i, o, proposals);
  return proposals;
}

Proposals blends(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    if (subject.at(i).op != Opcode::Mad)
      continue;
    for (const int o : {0, 1})
      proposeBlend(subject, i, o, proposals);
    proposeWeights(subject, i, proposals);
  }
  return proposals;
}

Proposals identities(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    if (!subject.flow().live(i))
      continue;
    proposeIdentity(subject, i, proposals);
    proposeMagnitude(subject, i, proposals);
  }
  return proposals;
}

} // namespace arbiter::tools::advise
