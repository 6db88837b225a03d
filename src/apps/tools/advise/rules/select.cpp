#include "apps/tools/advise/ranges.h"
#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds comparisons whose 1 or 0 only selects a value, and proposes CMP, which selects by a sign.
namespace arbiter::tools::advise {

namespace {

constexpr const char *kSelectByCmp = "select_by_cmp";

/// The operands between which CMP selects.
struct Arms {
  std::string ifOne, ifZero;
};

/// An instruction that selects by a comparison's result.
struct Chooser {
  std::uint32_t index = 0;
  int operand = 0; ///< the operand that reads the comparison
  std::uint32_t comparison = 0;
};

std::optional<std::string> armAt(const Subject &subject, const Chooser &chooser, int operand) {
  return subject.spelled(chooser.index, operand, subject.at(chooser.index).dst.mask, false);
}

bool withinOne(const Subject &subject, const Chooser &chooser, int operand) {
  const fp::analysis::ValueRange range =
      rangeOf(subject, chooser.index, operand, subject.at(chooser.index).dst.mask);
  return range.number && range.lo >= 0.0f && range.hi <= 1.0f;
}

/// Returns the instruction's values for a comparison result of 1 and of 0.
std::optional<Arms> armsOf(const Subject &subject, const Chooser &chooser) {
  const Instruction &instruction = subject.at(chooser.index);
  const bool negative = instruction.src[std::size_t(chooser.operand)].negate != 0;
  const bool first = chooser.operand == 0;
  if (instruction.op == Opcode::Cmp && first && negative) {
    const auto one = armAt(subject, chooser, 1), zero = armAt(subject, chooser, 2);
    return one && zero ? std::optional(Arms{*one, *zero}) : std::nullopt;
  }
  if (negative)
    return std::nullopt;
  if (instruction.op == Opcode::Lrp && first) {
    const auto one = armAt(subject, chooser, 1), zero = armAt(subject, chooser, 2);
    return one && zero ? std::optional(Arms{*one, *zero}) : std::nullopt;
  }
  if (chooser.operand > 1)
    return std::nullopt;
  const auto other = armAt(subject, chooser, 1 - chooser.operand);
  if (!other)
    return std::nullopt;
  if (instruction.op == Opcode::Mul)
    return Arms{*other, "0.0"};
  if (!withinOne(subject, chooser, 1 - chooser.operand))
    return std::nullopt;
  if (instruction.op == Opcode::Max)
    return Arms{"1.0", *other};
  if (instruction.op == Opcode::Min)
    return Arms{*other, "0.0"};
  return std::nullopt;
}

/// Returns an operand of the comparison as the selecting instruction would read it.
Operand seen(const Subject &subject, const Chooser &chooser, int operand) {
  Operand outer = subject.at(chooser.index).src[std::size_t(chooser.operand)];
  outer.negate = 0;
  return composed(outer, subject.at(chooser.comparison).src[std::size_t(operand)]);
}

std::optional<std::string> seenText(const Subject &subject, const Chooser &chooser, int operand,
                                    bool negative) {
  Operand read = seen(subject, chooser, operand);
  const std::uint8_t mask = subject.at(chooser.index).dst.mask;
  if (negative)
    read.negate = std::uint8_t(read.negate ^ 0xF);
  if (!subject.flow().holds(read, mask, chooser.comparison, chooser.index))
    return std::nullopt;
  return Subject::spelled(subject.base(chooser.comparison, operand), read, mask, false);
}

/// Replaces the selecting instruction by CMP with the operand \p sign.
void choose(const Subject &subject, const Chooser &chooser, const Arms &arms,
            const std::string &sign, Draft &draft) {
  const bool below = subject.at(chooser.comparison).op == Opcode::Slt;
  draft.replace(chooser.index, statementText(Opcode::Cmp, subject.at(chooser.index).dst.saturate,
                                             subject.destination(chooser.index),
                                             {sign, below ? arms.ifOne : arms.ifZero,
                                              below ? arms.ifZero : arms.ifOne}));
}

Proposal finished(const Subject &subject, const Chooser &chooser, const Draft &draft) {
  return draft.about(chooser.comparison, chooser.index, kSelectByCmp,
                     std::string(fp::ir::info(subject.at(chooser.comparison).op).mnemonic) +
                         " makes 1 or 0 and " +
                         fp::ir::info(subject.at(chooser.index).op).mnemonic +
                         " only chooses by it: CMP chooses by the sign of a difference");
}

/// Proposes to select by the sign of one operand if the other is 0.
void proposeSign(const Subject &subject, const Chooser &chooser, const Arms &arms,
                 Proposals &proposals) {
  for (const int zero : {0, 1}) {
    if (subject.number(chooser.comparison, zero) != 0.0f)
      continue;
    const auto sign = seenText(subject, chooser, 1 - zero, zero == 0);
    if (!sign)
      continue;
    Draft draft(subject);
    choose(subject, chooser, arms, *sign, draft);
    proposals.push_back(finished(subject, chooser, draft));
  }
}

/// Proposes to replace the comparison by a difference if all its readers select by it.
void proposeDifference(const Subject &subject, std::uint32_t comparison, Proposals &proposals) {
  const Instruction &instruction = subject.at(comparison);
  const std::uint8_t mask = instruction.dst.mask;
  const auto a = subject.spelled(comparison, 0, mask, false);
  const auto b = subject.spelled(comparison, 1, mask, false);
  if (!a || !b || instruction.dst.saturate || subject.flow().uses(comparison).empty())
    return;
  Draft draft(subject);
  draft.replace(comparison,
                statementText(Opcode::Sub, false, subject.destination(comparison), {*a, *b}));
  Chooser last;
  for (const Use &use : subject.flow().uses(comparison)) {
    const Chooser chooser{use.reader, use.operand, comparison};
    if (subject.flow().writer(use.reader, use.operand) != comparison ||
        !fp::ir::info(subject.at(use.reader).op).has(fp::ir::PerComponent))
      return;
    const std::optional<Arms> arms = armsOf(subject, chooser);
    Operand read = subject.at(use.reader).src[std::size_t(use.operand)];
    read.negate = 0;
    const auto sign = Subject::spelled(subject.destinationBase(comparison), read,
                                       subject.at(use.reader).dst.mask, false);
    if (!arms || !sign)
      return;
    choose(subject, chooser, *arms, *sign, draft);
    last = chooser;
  }
  proposals.push_back(finished(subject, last, draft));
}

bool compares(Opcode op) { return op == Opcode::Sge || op == Opcode::Slt; }

} // namespace

Proposals selects(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    if (!fp::ir::info(subject.at(i).op).has(fp::ir::PerComponent))
      continue;
    for (int o = 0; o < fp::ir::info(subject.at(i).op).operandCount(); ++o) {
      const std::optional<std::uint32_t> writer = subject.flow().writer(i, o);
      if (!writer || !compares(subject.at(*writer).op))
        continue;
      const Chooser chooser{i, o, *writer};
      if (const std::optional<Arms> arms = armsOf(subject, chooser))
        proposeSign(subject, chooser, *arms, proposals);
    }
  }
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    if (compares(subject.at(i).op))
      proposeDifference(subject, i, proposals);
  return proposals;
}

Proposals complements(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const Instruction &instruction = subject.at(i);
    const std::optional<std::uint32_t> writer = subject.flow().writer(i, 1);
    if (instruction.op != Opcode::Sub || subject.number(i, 0) != 1.0f || !writer ||
        !compares(subject.at(*writer).op) || instruction.src[1].negate != 0)
      continue;
    const Chooser chooser{i, 1, *writer};
    const auto a = seenText(subject, chooser, 0, false), b = seenText(subject, chooser, 1, false);
    if (!a || !b)
      continue;
    const bool below = subject.at(*writer).op == Opcode::Slt;
    Draft draft(subject);
    draft.replace(i, statementText(below ? Opcode::Sge : Opcode::Slt, instruction.dst.saturate,
                                   subject.destination(i), {*a, *b}));
    proposals.push_back(draft.about(*writer, i, "opposite_comparison",
                                    "1 minus a comparison is the opposite comparison"));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
