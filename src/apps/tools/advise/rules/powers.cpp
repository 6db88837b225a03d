#include <array>

#include "apps/tools/advise/ranges.h"
#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds POW with a small constant exponent. POW takes LG2, MUL and EX2; products or a reciprocal
/// are cheaper.
namespace arbiter::tools::advise {

namespace {

constexpr const char *kPowerByProducts = "power_by_products";

std::string scalarText(Opcode op, const std::string &destination, const std::string &operand) {
  return statementText(op, false, destination, {operand});
}

std::string product(bool saturate, const std::string &destination, const std::string &a,
                    const std::string &b) {
  return statementText(Opcode::Mul, saturate, destination, {a, b});
}

/// The statement that replaces POW, and the statements before it, which write \p scratch.
struct Replacement {
  std::vector<std::string> before;
  std::string statement;
};

std::optional<Replacement> replacementOf(float exponent, const std::string &base,
                                         const std::string &destination, bool saturate,
                                         const std::string &scratch) {
  const std::string x = scratch + ".x";
  const std::string temporary = "TEMP " + scratch;
  if (exponent == 1.0f)
    return Replacement{{}, statementText(Opcode::Mov, saturate, destination, {base})};
  if (exponent == 2.0f)
    return Replacement{{}, product(saturate, destination, base, base)};
  if (exponent == 3.0f)
    return Replacement{{temporary, product(false, x, base, base)},
                       product(saturate, destination, x, base)};
  if (exponent == 4.0f)
    return Replacement{{temporary, product(false, x, base, base)},
                       product(saturate, destination, x, x)};
  if (exponent == 0.5f)
    return Replacement{{temporary, scalarText(Opcode::Rsq, x, base)},
                       statementText(Opcode::Rcp, saturate, destination, {x})};
  if (exponent == -1.0f)
    return Replacement{{}, statementText(Opcode::Rcp, saturate, destination, {base})};
  if (exponent == -0.5f)
    return Replacement{{}, statementText(Opcode::Rsq, saturate, destination, {base})};
  return std::nullopt;
}

} // namespace

Proposals powers(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const fp::ir::Instruction &instruction = subject.at(i);
    if (instruction.op != Opcode::Pow)
      continue;
    const std::optional<float> exponent = subject.number(i, 1, 0);
    const auto base = subject.spelled(i, 0, 1, true);
    if (!exponent || !base)
      continue;
    const auto made = replacementOf(*exponent, *base, subject.destination(i),
                                    instruction.dst.saturate, subject.fresh("power"));
    if (!made)
      continue;
    Draft draft(subject);
    if (!made->before.empty())
      draft.insert(i, made->before);
    draft.replace(i, made->statement);
    Proposal proposal = draft.about(i, kPowerByProducts,
                                    "POW is LG2, MUL and EX2; the exponent " +
                                        numberText(*exponent) + " is less work",
                                    Nearness::Rounding);
    // POW of a negative base is 0, unlike the product.
    if (!rangeOf(subject, i, 0, 1).notNegative())
      proposal.condition = "the base " + *base + " is never below zero";
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
