#include <cmath>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

/// Finds arithmetic on constants, and constants that two consecutive instructions apply.
namespace arbiter::tools::advise {

namespace {

constexpr const char *kWork = "constant_work";
constexpr const char *kChain = "constant_chain";

bool isCopy(Opcode op) { return op == Opcode::Mov || op == Opcode::Swz; }

/// Returns the results of all instructions. Only those that depend on nothing but constants are
/// meaningful.
std::vector<Vec4> resultsOf(const fp::ir::Program &program) {
  std::vector<Vec4> results(program.code.size());
  fp::ir::Inputs inputs;
  inputs.result = [&](const Instruction &instruction, Vec4 &value) {
    Vec4 &result = results[std::size_t(&instruction - program.code.data())];
    for (std::size_t c = 0; c < 4; ++c)
      result[c] =
          instruction.dst.saturate ? fp::ir::saturated(value[c]) : fp::ir::flushed(value[c]);
  };
  (void)fp::ir::evaluate(program, inputs);
  return results;
}

bool allFinite(const Vec4 &value, std::uint8_t mask) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && !std::isfinite(value[c]))
      return false;
  return true;
}

/// Returns the value with zero in components outside the mask.
Vec4 masked(Vec4 value, std::uint8_t mask) {
  for (std::size_t c = 0; c < 4; ++c)
    if (!(mask >> c & 1))
      value[c] = 0.0f;
  return value;
}

/// Returns the constants at the positions that count, if all of them are constants.
std::optional<Vec4> numbersOf(const Subject &subject, std::uint32_t index, int operand) {
  const std::uint8_t mask = fp::ir::operandMask(subject.at(index), operand);
  Vec4 value = {};
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(mask >> c & 1))
      continue;
    const std::optional<float> number = subject.number(index, operand, int(c));
    if (!number)
      return std::nullopt;
    value[c] = *number;
  }
  return value;
}

/// factor * value + term with constants, by the positions of the destination.
struct Line {
  int value = 0; ///< number of the operand
  Vec4 factor = {1, 1, 1, 1};
  Vec4 term = {};
};

std::optional<Line> lineOf(const Subject &subject, std::uint32_t index) {
  const Opcode op = subject.at(index).op;
  if (op != Opcode::Add && op != Opcode::Sub && op != Opcode::Mul && op != Opcode::Mad)
    return std::nullopt;
  for (const int value : {0, 1}) {
    const auto other = numbersOf(subject, index, 1 - value);
    const auto third = op == Opcode::Mad ? numbersOf(subject, index, 2) : std::optional(Vec4{});
    if (!other || !third || numbersOf(subject, index, value))
      continue;
    Line line{value};
    for (std::size_t c = 0; c < 4; ++c) {
      if (op == Opcode::Mul || op == Opcode::Mad)
        line.factor[c] = (*other)[c];
      else if (op == Opcode::Sub && value == 1)
        line.factor[c] = -1.0f;
      line.term[c] = op == Opcode::Add || (op == Opcode::Sub && value == 1) ? (*other)[c]
                     : op == Opcode::Sub                                    ? -(*other)[c]
                                                                            : (*third)[c];
    }
    return line;
  }
  return std::nullopt;
}

std::string spelledNumbers(const Vec4 &value, std::uint8_t mask) {
  std::optional<float> one;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(mask >> c & 1))
      continue;
    if (one && *one != value[c])
      return vectorText(masked(value, mask));
    one = value[c];
  }
  return numberText(one.value_or(0.0f));
}

bool isAll(const Vec4 &value, std::uint8_t mask, float number) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && value[c] != number)
      return false;
  return true;
}

/// Returns the statement for a Line, with the text of its operand.
std::string lineText(const Subject &subject, std::uint32_t index, const Line &line,
                     const std::string &value) {
  const std::uint8_t mask = subject.at(index).dst.mask;
  const bool saturate = subject.at(index).dst.saturate;
  const std::string destination = subject.destination(index);
  const std::string factor = spelledNumbers(line.factor, mask);
  const std::string term = spelledNumbers(line.term, mask);
  if (isAll(line.factor, mask, 1.0f))
    return statementText(Opcode::Add, saturate, destination, {value, term});
  if (isAll(line.term, mask, 0.0f))
    return statementText(Opcode::Mul, saturate, destination, {value, factor});
  return statementText(Opcode::Mad, saturate, destination, {value, factor, term});
}

/// Proposes one instruction for two consecutive Lines.
void proposeChain(const Subject &subject, std::uint32_t second, Proposals &proposals) {
  const std::optional<Line> outer = lineOf(subject, second);
  const auto first = outer ? subject.flow().writer(second, outer->value) : std::nullopt;
  const std::optional<Line> inner = first ? lineOf(subject, *first) : std::nullopt;
  if (!inner || subject.at(*first).dst.saturate)
    return;
  const fp::ir::Operand &read = subject.at(second).src[std::size_t(outer->value)];
  const fp::ir::Operand through = composed(read, subject.at(*first).src[std::size_t(inner->value)]);
  const std::uint8_t mask = subject.at(second).dst.mask;
  fp::ir::Operand plain = through;
  plain.negate = subject.at(*first).src[std::size_t(inner->value)].negate;
  Line line{0};
  for (std::size_t c = 0; c < 4; ++c) {
    if (!(mask >> c & 1) || read.swizzle[c] > fp::ir::Select::W)
      continue;
    const auto from = std::size_t(read.swizzle[c]);
    const float sign = read.negate >> c & 1 ? -1.0f : 1.0f;
    line.factor[c] = sign * outer->factor[c] * inner->factor[from];
    line.term[c] = sign * outer->factor[c] * inner->term[from] + outer->term[c];
  }
  const auto value = Subject::spelled(subject.base(*first, inner->value), plain, mask, false);
  if (!value || !subject.flow().holds(plain, mask, *first, second))
    return;
  Draft draft(subject);
  draft.replace(second, lineText(subject, second, line, *value));
  proposals.push_back(
      draft.about(*first, second, kChain,
                  "numbers are brought in twice: their products and sums can be made once, here",
                  Nearness::Rounding));
}

} // namespace

Proposals constantWork(const Subject &subject) {
  Proposals proposals;
  std::vector<Vec4> results;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const Instruction &instruction = subject.at(i);
    if (!subject.flow().live(i) || subject.flow().depends(i) != Depends::Constant ||
        isCopy(instruction.op) || !subject.flow().endsKind(i))
      continue;
    if (results.empty())
      results = resultsOf(subject.program());
    const std::uint8_t mask = instruction.dst.mask;
    if (!allFinite(results[i], mask))
      continue;
    const std::string name = subject.fresh("computed");
    Draft draft(subject);
    draft.insert(i, {"PARAM " + name + " = " + vectorText(masked(results[i], mask))});
    readInstead(subject, i, name, draft);
    proposals.push_back(draft.about(i, kWork,
                                    std::string(fp::ir::info(instruction.op).mnemonic) +
                                        " of numbers is the same for every " +
                                        subject.fragmentOrVertex() + ": it can be a number"));
  }
  return proposals;
}

Proposals constantChain(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    proposeChain(subject, i, proposals);
  return proposals;
}

} // namespace arbiter::tools::advise
