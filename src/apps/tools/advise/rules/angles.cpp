#include <numbers>

#include "apps/tools/advise/ranges.h"
#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::tools::advise {

namespace {

/// SIN and COS of one angle; `early` comes first in the text.
struct Turn {
  std::uint32_t early, late;
};

std::vector<Turn> turnsOf(const Subject &subject) {
  std::vector<Turn> turns;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    const Opcode op = subject.at(i).op;
    if (op != Opcode::Sin && op != Opcode::Cos)
      continue;
    const Opcode other = op == Opcode::Sin ? Opcode::Cos : Opcode::Sin;
    for (std::uint32_t j = i + 1; j < subject.size(); ++j)
      if (subject.at(j).op == other &&
          fp::opt::sameReads(subject.at(i).src[0], subject.at(j).src[0], 1) &&
          subject.flow().holds(subject.at(i).src[0], 1, i, j)) {
        turns.push_back({i, j});
        break;
      }
  }
  return turns;
}

std::string copyOf(const Subject &subject, std::uint32_t index, const std::string &name) {
  return statementText(Opcode::Mov, subject.at(index).dst.saturate, subject.destination(index),
                       {name + (subject.at(index).op == Opcode::Cos ? ".x" : ".y")});
}

Proposal proposed(const Subject &subject, const Turn &turn) {
  const std::string name = subject.fresh("cosine_sine");
  const std::string angle = subject.tokens(subject.at(turn.early).src[0].span);
  Draft draft(subject);
  draft.insert(turn.early, {"TEMP " + name, "SCS " + name + ".xy, " + angle});
  draft.replace(turn.early, copyOf(subject, turn.early, name));
  draft.replace(turn.late, copyOf(subject, turn.late, name));
  return draft.about(turn.early, turn.late, "sine_and_cosine",
                     "SCS gives the cosine and the sine of one angle at once");
}

} // namespace

Proposals sineAndCosine(const Subject &subject) {
  Proposals proposals;
  for (const Turn &turn : turnsOf(subject)) {
    Proposal proposal = proposed(subject, turn);
    const fp::analysis::ValueRange range = rangeOf(subject, turn.early, 0, 1);
    // SIN and COS accept any angle, SCS only those within one turn (3.11.5.23).
    if (range.lo < -std::numbers::pi_v<float> || range.hi > std::numbers::pi_v<float>)
      proposal.condition = "the angle stays within -pi and pi, as SCS asks";
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
