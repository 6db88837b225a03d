#include <algorithm>
#include <bit>

#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/values.h"

/// Finds repeated work, copies, and work whose result is unused.
namespace arbiter::tools::advise {

namespace {

constexpr const char *kDead = "dead_work";

/// True if the first instruction has already computed everything that the second writes.
bool isSame(const Subject &subject, std::uint32_t first, std::uint32_t second) {
  const Instruction &a = subject.at(first), &b = subject.at(second);
  const fp::ir::OpInfo &row = fp::ir::info(a.op);
  if (a.op != b.op || a.dst.saturate != b.dst.saturate || a.dst.file != File::Temporary ||
      row.has(fp::ir::Kills) || row.has(fp::ir::VertexOnly) || a.unit != b.unit ||
      a.target != b.target)
    return false;
  if (!row.has(fp::ir::Replicates) && (b.dst.mask & ~a.dst.mask) != 0)
    return false;
  for (int o = 0; o < row.operandCount(); ++o) {
    const Operand &x = a.src[std::size_t(o)], &y = b.src[std::size_t(o)];
    const std::uint8_t mask = fp::ir::operandMask(b, o);
    if (!fp::opt::sameReads(x, y, mask) || !subject.flow().holds(x, mask, first, second))
      return false;
  }
  return true;
}

/// Returns the operand that reads the first result in place of the second.
std::string readOf(const Subject &subject, std::uint32_t first, std::uint32_t second) {
  const Instruction &a = subject.at(first);
  const bool replicated = fp::ir::info(a.op).has(fp::ir::Replicates);
  std::string base = subject.destinationBase(first);
  if (!replicated || (a.dst.mask & subject.at(second).dst.mask) == subject.at(second).dst.mask)
    return base;
  return base + maskText(std::uint8_t(a.dst.mask & -a.dst.mask));
}

Operand resultOf(const Instruction &instruction) {
  Operand operand;
  operand.file = instruction.dst.file;
  operand.index = instruction.dst.index;
  return operand;
}

bool isPlainCopy(const Instruction &instruction) {
  return instruction.op == Opcode::Mov && !instruction.dst.saturate;
}

/// Makes all readers of a copy read the copied register.
std::optional<Draft> readThrough(const Subject &subject, std::uint32_t copy) {
  const Operand &from = subject.at(copy).src[0];
  const std::string base = subject.base(copy, 0);
  Draft draft(subject);
  for (const Use &use : subject.flow().uses(copy)) {
    const Instruction &reader = subject.at(use.reader);
    const std::uint8_t mask = fp::ir::operandMask(reader, use.operand);
    const Operand read = composed(reader.src[std::size_t(use.operand)], from);
    const auto text =
        Subject::spelled(base, read, mask, fp::ir::info(reader.op).shapes[use.operand] == 'S');
    if (!text || reader.op == Opcode::Swz || !subject.flow().holds(read, mask, copy, use.reader))
      return std::nullopt;
    draft.replaceOperand(use.reader, use.operand, *text);
  }
  draft.remove(copy);
  return draft;
}

/// Makes the instruction that computes a copied value write to the copy's destination.
std::optional<Draft> writeThrough(const Subject &subject, std::uint32_t copy) {
  const auto writer = subject.flow().writer(copy, 0);
  const Instruction &move = subject.at(copy);
  if (!writer || !subject.flow().onlyUse(*writer) || move.src[0].negate != 0 ||
      move.src[0].swizzle != fp::ir::kIdentity || move.dst.file != File::Output)
    return std::nullopt;
  for (std::uint32_t i = *writer; i < copy; ++i)
    if (subject.at(i).dst.file == File::Output && subject.at(i).dst.index == move.dst.index)
      return std::nullopt;
  Draft draft(subject);
  draft.remove(copy);
  draft.replace(*writer, restated(subject, *writer, subject.destination(copy),
                                  subject.at(*writer).dst.saturate));
  return draft;
}

} // namespace

Proposals repeats(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t j = 1; j < subject.size(); ++j)
    for (std::uint32_t i = 0; i < j; ++i) {
      if (!subject.flow().live(i) || !subject.flow().live(j) || isPlainCopy(subject.at(j)) ||
          !isSame(subject, i, j))
        continue;
      const std::string message =
          std::string(fp::ir::info(subject.at(j).op).mnemonic) + " computes what line " +
          std::to_string(fp::locate(subject.text(), subject.at(i).span.begin).line) +
          " has computed";
      const std::string read = readOf(subject, i, j);
      const auto copied = statementText(Opcode::Mov, false, subject.destination(j), {read});
      if (subject.flow().holds(resultOf(subject.at(i)), subject.at(i).dst.mask, i + 1, j)) {
        Draft draft(subject);
        draft.replace(j, copied);
        proposals.push_back(draft.about(j, "repeated_work", message));
        break;
      }
      const std::string name = subject.fresh("kept");
      Draft draft(subject);
      draft.insert(i, {"TEMP " + name});
      draft.replace(i, restated(subject, i, name + maskText(subject.at(i).dst.mask),
                                subject.at(i).dst.saturate) +
                           "; " +
                           statementText(Opcode::Mov, false, subject.destination(i), {name}));
      const bool replicated = read.size() > subject.destinationBase(i).size();
      draft.replace(j, statementText(Opcode::Mov, false, subject.destination(j),
                                     {name + (replicated ? read.substr(read.rfind('.')) : "")}));
      proposals.push_back(draft.about(j, "repeated_work", message));
      break;
    }
  return proposals;
}

Proposals copies(const Subject &subject) {
  Proposals proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    if (!isPlainCopy(subject.at(i)) || !subject.flow().live(i))
      continue;
    const bool readable = subject.at(i).dst.file == File::Temporary && subject.flow().readAlone(i);
    const std::optional<Draft> draft =
        readable ? readThrough(subject, i) : writeThrough(subject, i);
    if (draft)
      proposals.push_back(
          draft->about(i, "needless_copy",
                       "MOV is not needed: what it copies can be read or written in its place"));
  }
  return proposals;
}

Proposals deadWork(const Subject &subject) {
  std::vector<std::uint32_t> dead;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    if (!subject.flow().live(i))
      dead.push_back(i);
  Proposals proposals;
  Draft all(subject);
  for (const std::uint32_t each : dead)
    all.remove(each);
  // Single proposals are useful only if there are few.
  constexpr std::size_t kFew = 16;
  if (dead.size() > 1)
    proposals.push_back(
        all.about(dead.front(), dead.back(), kDead,
                  "nothing reads what " + std::to_string(dead.size()) + " instructions compute"));
  for (std::size_t i = 0; i < dead.size() && dead.size() <= kFew; ++i) {
    Draft draft(subject);
    draft.remove(dead[i]);
    proposals.push_back(draft.about(dead[i], kDead, "nothing reads what this computes"));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
