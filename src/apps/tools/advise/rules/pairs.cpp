#include <algorithm>
#include <array>
#include <bit>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/values.h"

/// Finds two chains of the same scalar operations, and proposes one chain on two components.
namespace arbiter::tools::advise {

namespace {

constexpr std::size_t kMaxProposals = 256, kMaxTried = 2048;
constexpr std::uint32_t kMaxApart = 48; ///< maximum distance of the chains' first instructions
constexpr std::size_t kMaxSteps = 8;
constexpr const char *kScalarsToVector = "scalars_to_vector";

/// One operation, which both chains have.
struct Step {
  std::array<std::uint32_t, 2> at = {}; ///< the instruction in each chain
  int through = -1; ///< the operand that reads the previous step; none for the first

  [[nodiscard]] std::uint32_t early() const { return std::min(at[0], at[1]); }
  [[nodiscard]] std::uint32_t late() const { return std::max(at[0], at[1]); }
};
using Steps = std::vector<Step>;

bool isScalar(const Subject &subject, std::uint32_t index) {
  const Instruction &instruction = subject.at(index);
  return fp::ir::info(instruction.op).has(fp::ir::PerComponent) &&
         instruction.op != fp::ir::Opcode::Swz && instruction.dst.file == File::Temporary &&
         std::has_single_bit(instruction.dst.mask) && subject.flow().live(index);
}

bool isAlike(const Subject &subject, const Step &step) {
  const Instruction &a = subject.at(step.at[0]), &b = subject.at(step.at[1]);
  return step.at[0] != step.at[1] && isScalar(subject, step.at[0]) &&
         isScalar(subject, step.at[1]) && a.op == b.op && a.dst.saturate == b.dst.saturate;
}

/// Returns the component that a scalar instruction writes.
std::size_t positionOf(const Instruction &instruction) {
  return std::size_t(std::countr_zero(instruction.dst.mask));
}

/// Writes the steps as vector instructions.
class Writer {
public:
  explicit Writer(const Subject &subject)
      : m_subject(subject), m_draft(subject), m_name(subject.fresh("pair")) {}

  /// Returns the proposal.
  /// \param swapped true if the second chain becomes x
  std::optional<Proposal> write(const Steps &steps, bool swapped) {
    m_swapped = swapped;
    for (const Step &step : steps)
      if (!writeStep(step, step.at == steps.front().at))
        return std::nullopt;
    if (!endChains(steps.back()))
      return std::nullopt;
    return m_draft.about(steps.front().early(), steps.back().late(), kScalarsToVector,
                         std::string(fp::ir::info(m_subject.at(steps.front().at[0]).op).mnemonic) +
                             (steps.size() > 1 ? " and what follows it is" : " is") +
                             " done twice on one component: once on two is enough");
  }

private:
  [[nodiscard]] std::uint32_t lane(const Step &step, std::size_t at) const {
    return step.at[m_swapped ? 1 - at : at];
  }

  bool writeStep(const Step &step, bool first) {
    std::vector<std::string> before, operands;
    if (first)
      before.push_back("TEMP " + m_name);
    const Instruction &instruction = m_subject.at(step.at[0]);
    for (int o = 0; o < fp::ir::info(instruction.op).operandCount(); ++o) {
      const auto text =
          o == step.through ? std::optional(throughText(step, o)) : operandText(step, o, before);
      if (!text || text->empty())
        return false;
      operands.push_back(*text);
    }
    if (!before.empty())
      m_draft.insert(step.late(), before);
    m_draft.remove(step.early());
    m_draft.replace(step.late(), statementText(instruction.op, instruction.dst.saturate,
                                               m_name + ".xy", operands));
    return true;
  }

  [[nodiscard]] bool isNegative(const Step &step, std::size_t at, int operand) const {
    const Instruction &instruction = m_subject.at(lane(step, at));
    return (instruction.src[std::size_t(operand)].negate >> positionOf(instruction) & 1) != 0;
  }

  /// Returns the operand that reads the previous step; empty if the signs differ.
  [[nodiscard]] std::string throughText(const Step &step, int operand) const {
    if (isNegative(step, 0, operand) != isNegative(step, 1, operand))
      return "";
    return (isNegative(step, 0, operand) ? "-" : "") + m_name;
  }

  [[nodiscard]] std::optional<std::string> operandText(const Step &step, int operand,
                                                       std::vector<std::string> &before) {
    const auto number = [&](std::size_t at) {
      return m_subject.number(lane(step, at), operand,
                              int(positionOf(m_subject.at(lane(step, at)))));
    };
    const std::optional<float> x = number(0), y = number(1);
    if (x && y && *x == *y)
      return numberText(*x);
    if (x && y) {
      const std::string name = m_subject.fresh(m_name + "_numbers") +
                               (m_numbers++ == 0 ? "" : std::to_string(m_numbers));
      before.push_back("PARAM " + name + " = " + vectorText({*x, *y, 0, 0}));
      return name;
    }
    return registerText(step, operand);
  }

  /// Returns the operand if both chains read components of one register.
  [[nodiscard]] std::optional<std::string> registerText(const Step &step, int operand) const {
    const Operand &a = m_subject.at(lane(step, 0)).src[std::size_t(operand)];
    const Operand &b = m_subject.at(lane(step, 1)).src[std::size_t(operand)];
    const Operand &early = m_subject.at(step.early()).src[std::size_t(operand)];
    const auto mask = m_subject.at(step.early()).dst.mask;
    if (a.relative || b.relative || !fp::opt::sameRegister(a, b) ||
        !m_subject.flow().holds(early, mask, step.early(), step.late()))
      return std::nullopt;
    Operand both = a;
    both.negate = 0;
    const std::size_t from[] = {positionOf(m_subject.at(lane(step, 0))),
                                positionOf(m_subject.at(lane(step, 1)))};
    both.swizzle[0] = a.swizzle[from[0]];
    both.swizzle[1] = b.swizzle[from[1]];
    both.negate = std::uint8_t((isNegative(step, 0, operand) ? 1 : 0) |
                               (isNegative(step, 1, operand) ? 2 : 0));
    return Subject::spelled(m_subject.base(lane(step, 0), operand), both, 3, false);
  }

  /// Makes readers of the chains' results read the pair.
  bool endChains(const Step &last) {
    for (const std::size_t at : {0, 1}) {
      const std::uint32_t index = lane(last, at);
      if (!m_subject.flow().readAlone(index))
        return false;
      for (const Use &use : m_subject.flow().uses(index)) {
        const Instruction &reader = m_subject.at(use.reader);
        const Operand &source = reader.src[std::size_t(use.operand)];
        const std::uint8_t mask = fp::ir::operandMask(reader, use.operand);
        const std::uint8_t signs = source.negate & mask;
        if (use.reader <= last.late() || reader.op == fp::ir::Opcode::Swz ||
            (signs != 0 && signs != mask))
          return false;
        m_draft.replaceOperand(use.reader, use.operand,
                               (signs != 0 ? "-" : "") + m_name + (at == 0 ? ".x" : ".y"));
      }
    }
    return true;
  }

  const Subject &m_subject;
  Draft m_draft;
  std::string m_name;
  bool m_swapped = false;
  int m_numbers = 0;
};

/// Returns the next step if both chains continue with the same operation.
std::optional<Step> next(const Subject &subject, const Step &step) {
  const auto one = subject.flow().onlyUse(step.at[0]), other = subject.flow().onlyUse(step.at[1]);
  if (!one || !other || one->operand != other->operand)
    return std::nullopt;
  const Step found{{one->reader, other->reader}, one->operand};
  if (!isAlike(subject, found) || found.late() <= step.late() ||
      subject.flow().writer(one->reader, one->operand) != step.at[0] ||
      subject.flow().writer(other->reader, other->operand) != step.at[1])
    return std::nullopt;
  return found;
}

void propose(const Subject &subject, Steps steps, Proposals &proposals) {
  while (true) {
    for (const bool swapped : {false, true})
      if (auto proposal = Writer(subject).write(steps, swapped))
        proposals.push_back(std::move(*proposal));
    const std::optional<Step> more = next(subject, steps.back());
    if (!more || steps.size() >= kMaxSteps)
      return;
    steps.push_back(*more);
  }
}

} // namespace

Proposals scalarPairs(const Subject &subject) {
  Proposals proposals;
  std::size_t tried = 0;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (std::uint32_t j = i + 1; j < std::min(subject.size(), i + kMaxApart); ++j)
      if (isAlike(subject, {{i, j}}) && proposals.size() < kMaxProposals && tried++ < kMaxTried)
        propose(subject, {Step{{i, j}}}, proposals);
  return proposals;
}

} // namespace arbiter::tools::advise
