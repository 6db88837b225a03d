#include "apps/tools/advise/rules/free_inputs.h"
#include "apps/tools/advise/rules/rules.h"

/// Finds work that depends only on parameters, and so is the same for every pixel of a draw. The
/// application can do it once.
namespace arbiter::tools::advise {

Proposals parameterWork(const Subject &subject) {
  Proposals proposals;
  const std::optional<std::uint16_t> local = freeLocal(subject);
  for (std::uint32_t i = 0; local && i < subject.size(); ++i) {
    const fp::ir::Instruction &instruction = subject.at(i);
    if (!subject.flow().live(i) || subject.flow().depends(i) != Depends::Parameter ||
        instruction.op == Opcode::Mov || !subject.flow().endsKind(i))
      continue;
    const std::string binding = localText(*local);
    const std::string name = subject.fresh("computed");
    Draft draft(subject);
    draft.insert(i, {"PARAM " + name + " = " + binding});
    readInstead(subject, i, name, draft);
    Proposal proposal =
        draft.about(i, "parameter_work",
                    std::string(fp::ir::info(instruction.op).mnemonic) +
                        " of parameters is the same for every " + subject.fragmentOrVertex() +
                        " of a draw: the application can compute it once");
    proposal.derived.push_back({Derived::Kind::Local, std::uint8_t(*local), i});
    proposal.application = "sets " + binding + " to what " + subject.destination(i) + " is here";
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
