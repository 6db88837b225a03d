#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools::advise {

namespace {

constexpr const char *kClampBySat = "clamp_by_sat";
constexpr const char *kMessage =
    "MAX and MIN clamp to [0,1], which _SAT does within the instruction that computes the value";

/// Returns the other operand if one of two operands is the number.
std::optional<int> besideNumber(const Subject &subject, std::uint32_t index, float number) {
  for (int o = 0; o < 2; ++o)
    if (subject.number(index, o) == number)
      return 1 - o;
  return std::nullopt;
}

/// Returns the operand that MAX bounds by 0 or MIN bounds by 1.
std::optional<int> bounded(const Subject &subject, std::uint32_t index) {
  const Instruction &instruction = subject.at(index);
  if (instruction.op == Opcode::Max)
    return besideNumber(subject, index, 0.0f);
  if (instruction.op == Opcode::Min)
    return besideNumber(subject, index, 1.0f);
  return std::nullopt;
}

/// True if the operand has no swizzle and no sign at the positions of the mask.
bool isPlain(const fp::ir::Operand &operand, std::uint8_t mask) {
  for (std::size_t i = 0; i < 4; ++i)
    if ((mask >> i & 1) &&
        (operand.swizzle[i] != fp::ir::kIdentity[i] || (operand.negate >> i & 1)))
      return false;
  return true;
}

/// A bound followed by the other bound.
struct Clamp {
  std::uint32_t first, second;
  int value;  ///< the operand of the first
  int result; ///< the operand of the second that reads the first
};

std::optional<Clamp> clampAt(const Subject &subject, std::uint32_t second) {
  const std::optional<int> result = bounded(subject, second);
  const auto first = result ? subject.flow().writer(second, *result) : std::nullopt;
  if (!first || subject.at(*first).op == subject.at(second).op || subject.at(*first).dst.saturate ||
      !subject.flow().onlyUse(*first))
    return std::nullopt;
  const std::optional<int> value = bounded(subject, *first);
  if (!value)
    return std::nullopt;
  return Clamp{*first, second, *value, *result};
}

/// Proposes a copy with _SAT in place of the second bound.
void proposeCopy(const Subject &subject, const Clamp &clamp, Proposals &proposals) {
  const Instruction &second = subject.at(clamp.second);
  const fp::ir::Operand &value = subject.at(clamp.first).src[std::size_t(clamp.value)];
  const fp::ir::Operand read = composed(second.src[std::size_t(clamp.result)], value);
  const std::uint8_t mask = second.dst.mask;
  const auto text = Subject::spelled(subject.base(clamp.first, clamp.value), read, mask, false);
  if (!text || !subject.flow().holds(read, mask, clamp.first, clamp.second))
    return;
  Draft draft(subject);
  draft.replace(clamp.second,
                statementText(Opcode::Mov, true, subject.destination(clamp.second), {*text}));
  proposals.push_back(draft.about(clamp.first, clamp.second, kClampBySat, kMessage));
}

/// Proposes _SAT on the instruction that computes the value.
void proposeWriter(const Subject &subject, const Clamp &clamp, Proposals &proposals) {
  const Flow &flow = subject.flow();
  const auto writer = flow.writer(clamp.first, clamp.value);
  if (!writer || subject.at(*writer).dst.saturate || !flow.onlyUse(*writer))
    return;
  const Instruction &instruction = subject.at(*writer), &second = subject.at(clamp.second);
  const std::uint8_t mask = second.dst.mask;
  const fp::ir::Operand &read = second.src[std::size_t(clamp.result)];
  if (!isPlain(subject.at(clamp.first).src[std::size_t(clamp.value)], mask) || !isPlain(read, mask))
    return;
  const std::string own = subject.destination(*writer);
  Draft draft(subject);
  draft.replace(*writer, restated(subject, *writer, own, true)).remove(clamp.first);
  if (own == subject.destination(clamp.second) && !second.dst.saturate)
    draft.remove(clamp.second);
  else
    draft.replace(clamp.second, statementText(Opcode::Mov, false, subject.destination(clamp.second),
                                              {subject.destinationBase(*writer)}));
  if (instruction.dst.file == fp::ir::File::Temporary)
    proposals.push_back(draft.about(clamp.first, clamp.second, kClampBySat, kMessage));
}

} // namespace

Proposals clamps(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    if (const std::optional<Clamp> clamp = clampAt(subject, i)) {
      proposeWriter(subject, *clamp, proposals);
      proposeCopy(subject, *clamp, proposals);
    }
  return proposals;
}

} // namespace arbiter::tools::advise
