#include <algorithm>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds better places for samples and KIL, because their order determines the texture nodes.
namespace arbiter::tools::advise {

namespace {

constexpr std::size_t kMaxPlaces = 24;

bool samples(const Instruction &instruction) {
  return fp::ir::info(instruction.op).has(fp::ir::Texture);
}
bool discards(const Instruction &instruction) {
  return fp::ir::info(instruction.op).has(fp::ir::Kills);
}

/// Moves a statement before the one at \p to.
Draft moved(const Subject &subject, std::uint32_t from, std::uint32_t to,
            const std::string &statement) {
  Draft draft(subject);
  draft.insert(to, {statement});
  draft.remove(from);
  return draft;
}

/// Returns the earliest place at which the operand has its value and the destination is unused.
std::uint32_t earliest(const Subject &subject, std::uint32_t index) {
  const Instruction &instruction = subject.at(index);
  std::uint32_t place = index;
  while (place > 0) {
    const std::uint32_t before = place - 1;
    if (!subject.flow().holds(instruction.src[0], fp::ir::operandMask(instruction, 0), before,
                              index))
      break;
    if (!discards(instruction) &&
        (instruction.dst.file != File::Temporary ||
         !subject.flow().untouched(instruction.dst.index, instruction.dst.mask, before, index)))
      break;
    place = before;
  }
  return place;
}

/// Proposes to sample into a new register, as early as the operand allows.
std::optional<Proposal> renamed(const Subject &subject, std::uint32_t index) {
  const Instruction &instruction = subject.at(index);
  std::uint32_t place = index;
  while (place > 0 && subject.flow().holds(instruction.src[0], fp::ir::operandMask(instruction, 0),
                                           place - 1, index))
    --place;
  if (place == index || instruction.dst.file != File::Temporary)
    return std::nullopt;
  const std::string name = subject.fresh("sampled");
  Draft draft(subject);
  draft.insert(place,
               {"TEMP " + name, restated(subject, index, name + maskText(instruction.dst.mask),
                                         instruction.dst.saturate)});
  readInstead(subject, index, name, draft);
  return draft.about(index, "sample_earlier",
                     "this sample's coordinate is there earlier: beside other samples it begins no "
                     "node of its own");
}

} // namespace

Proposals earlySamples(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    if (!samples(subject.at(i)) || !subject.flow().live(i))
      continue;
    const std::uint32_t place = earliest(subject, i);
    if (place < i) {
      const std::string statement =
          restated(subject, i, subject.destination(i), subject.at(i).dst.saturate);
      proposals.push_back(moved(subject, i, place, statement)
                              .about(i, "sample_earlier",
                                     "this sample's coordinate is there earlier: beside other "
                                     "samples it begins no node of its own"));
    }
    if (auto proposal = renamed(subject, i))
      proposals.push_back(std::move(*proposal));
  }
  return proposals;
}

Proposals killPlaces(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const Instruction &instruction = subject.at(i);
    if (!discards(instruction))
      continue;
    const std::string statement = "KIL " + subject.tokens(instruction.src[0].span);
    const auto add = [&](std::uint32_t place) {
      proposals.push_back(
          moved(subject, i, place, statement)
              .about(i, "kil_place", "KIL counts as a sample: beside others it begins no node"));
    };
    if (const std::uint32_t place = earliest(subject, i); place < i)
      add(place);
    // Try the place before each later sample while the operand keeps its value.
    for (std::uint32_t to = i + 1; to < subject.size() && proposals.size() < kMaxPlaces; ++to) {
      if (!subject.flow().holds(instruction.src[0], 0xF, i, to))
        break;
      if (samples(subject.at(to)))
        add(to);
    }
  }
  return proposals;
}

} // namespace arbiter::tools::advise
