#include "fp_compiler/ir/reads.h"
#include "tools/advise/rules/free_inputs.h"
#include "tools/advise/rules/rules.h"

/// What interpolation can do: values that are linear in texture coordinates, and components that
/// are wanted in another order.
namespace arbiter::tools::advise {

namespace {

using fp::ir::AttributeKind;
using fp::ir::File;
using fp::ir::Opcode;

/// Other attributes are clamped, flat, or no plane of the triangle.
bool ofTexCoordsAlone(const Subject &subject, std::uint32_t index) {
  const std::vector<bool> &read = subject.flow().attributes(index);
  for (std::size_t a = 0; a < read.size(); ++a)
    if (read[a] && subject.program().attributes[a].kind != AttributeKind::TexCoord)
      return false;
  return true;
}

/// The operand reads components of a register in another order than they have.
bool isReordered(const Subject &subject, std::uint32_t index, int operand) {
  const std::uint8_t mask = fp::ir::operandMask(subject.at(index), operand);
  const fp::ir::Operand &source = subject.at(index).src[std::size_t(operand)];
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && source.swizzle[c] <= fp::ir::Select::W &&
        source.swizzle[c] != fp::ir::kIdentity[c])
      return true;
  return false;
}

constexpr const char *kOrder = "component-order";
constexpr const char *kOrderMessage =
    "the card has no such swizzle and copies for it: the components can come in this order";

/// Numbers in the order that they are read in.
std::optional<Proposal> orderOfNumbers(const Subject &subject, std::uint32_t index, int operand) {
  const std::uint8_t mask = fp::ir::operandMask(subject.at(index), operand);
  fp::ir::Vec4 value = {};
  for (std::size_t c = 0; c < 4; ++c) {
    const auto number = subject.number(index, operand, int(c));
    if ((mask >> c & 1) && !number)
      return std::nullopt;
    value[c] = mask >> c & 1 ? *number : 0.0f;
  }
  const std::string name = subject.fresh("ordered");
  Draft draft(subject);
  draft.insert(index, {"PARAM " + name + " = " + vectorText(value)});
  draft.replaceOperand(index, operand, name);
  return draft.about(index, kOrder, kOrderMessage);
}

/// A register of the application's.
std::optional<Proposal> orderOfInput(const Subject &subject, std::uint32_t index, int operand) {
  const fp::ir::Operand &source = subject.at(index).src[std::size_t(operand)];
  const bool attribute = source.file == File::Attribute;
  if (attribute && subject.program().attributes[source.index].kind != AttributeKind::TexCoord)
    return std::nullopt;
  std::string binding;
  Derived derived{Derived::Kind::TexCoord, 0, index, operand};
  if (attribute) {
    const auto free = freeTexCoord(subject);
    if (!free)
      return std::nullopt;
    derived.index = *free;
    binding = texCoordText(*free);
  } else {
    const auto free = freeLocal(subject);
    if (!free)
      return std::nullopt;
    derived.kind = Derived::Kind::Local;
    derived.index = std::uint8_t(*free);
    binding = localText(*free);
  }
  const std::string name = subject.fresh("ordered");
  Draft draft(subject);
  draft.insert(index, {(attribute ? "ATTRIB " : "PARAM ") + name + " = " + binding});
  draft.replaceOperand(index, operand, name);
  Proposal proposal = draft.about(index, kOrder, kOrderMessage);
  proposal.derived.push_back(derived);
  proposal.application = "gives " + binding + " the components of " +
                         subject.tokens(source.span) + " in this order";
  return proposal;
}

} // namespace

Proposals linearWork(const Subject &subject) {
  Proposals proposals;
  const std::optional<std::uint8_t> free = freeTexCoord(subject);
  for (std::uint32_t i = 0; free && i < subject.size(); ++i) {
    const fp::ir::Instruction &instruction = subject.at(i);
    if (subject.program().language != fp::ir::Language::ArbFragment || !subject.flow().live(i) ||
        subject.flow().depends(i) != Depends::Affine || !ofTexCoordsAlone(subject, i) ||
        !subject.flow().endsKind(i))
      continue;
    const std::string name = subject.fresh("moved");
    Draft draft(subject);
    draft.insert(i, {"ATTRIB " + name + " = " + texCoordText(*free)});
    readInstead(subject, i, name, draft);
    Proposal proposal = draft.about(
        i, "linear-work",
        std::string(fp::ir::info(instruction.op).mnemonic) +
            " is linear in texture coordinates: the vertex stage can compute it, and "
            "interpolation keeps it");
    proposal.derived.push_back({Derived::Kind::TexCoord, *free, i});
    proposal.application = "writes what " + subject.destination(i) + " is here to result.texcoord[" +
                           std::to_string(*free) + "] of its vertex program";
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

Proposals operandOrder(const Subject &subject) {
  Proposals proposals;
  if (subject.program().language != fp::ir::Language::ArbFragment)
    return proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (int o = 0; o < fp::ir::info(subject.at(i).op).operandCount(); ++o) {
      const fp::ir::Operand &source = subject.at(i).src[std::size_t(o)];
      if ((source.file != File::Attribute && source.file != File::Parameter) || source.relative ||
          fp::ir::info(subject.at(i).op).shapes[o] == 'S' || subject.at(i).op == Opcode::Swz ||
          !isReordered(subject, i, o))
        continue;
      auto proposal = orderOfNumbers(subject, i, o);
      if (!proposal)
        proposal = orderOfInput(subject, i, o);
      if (proposal)
        proposals.push_back(std::move(*proposal));
    }
  return proposals;
}

} // namespace arbiter::tools::advise
