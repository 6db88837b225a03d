#include <algorithm>

#include "apps/tools/advise/rules/free_inputs.h"
#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds work that interpolation can do: values linear in texture coordinates, and reordered
/// components.
namespace arbiter::tools::advise {

namespace {

/// True if the result depends on no attributes but texture coordinates. Others are clamped, flat,
/// or not planar on the triangle.
bool ofTexCoordsAlone(const Subject &subject, std::uint32_t index) {
  const std::vector<bool> &read = subject.flow().attributes(index);
  for (std::size_t a = 0; a < read.size(); ++a)
    if (read[a] && subject.program().attributes[a].kind != AttributeKind::TexCoord)
      return false;
  return true;
}

/// True if the operand reads components in another order than the register's.
bool isReordered(const Subject &subject, std::uint32_t index, int operand) {
  const std::uint8_t mask = fp::ir::operandMask(subject.at(index), operand);
  const fp::ir::Operand &source = subject.at(index).src[std::size_t(operand)];
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && source.swizzle[c] <= fp::ir::Select::W &&
        source.swizzle[c] != fp::ir::kIdentity[c])
      return true;
  return false;
}

bool isLinear(const Subject &subject, std::uint32_t index) {
  return subject.program().language == fp::ir::Language::ArbFragment &&
         subject.flow().live(index) && subject.flow().depends(index) == Depends::Affine &&
         ofTexCoordsAlone(subject, index) && subject.flow().endsKind(index);
}

/// Proposes free texture coordinate sets for as many of the values as possible.
std::optional<Proposal> movedToVertices(const Subject &subject,
                                        const std::vector<std::uint32_t> &values) {
  const std::vector<std::uint8_t> sets = freeTexCoords(subject);
  const std::size_t count = std::min(values.size(), sets.size());
  if (count == 0)
    return std::nullopt;
  const std::string stem = subject.fresh("moved");
  std::string written, results;
  std::vector<Derived> derived;
  Draft draft(subject);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = i == 0 ? stem : stem + "_" + std::to_string(i + 1);
    draft.insert(values[i], {"ATTRIB " + name + " = " + texCoordText(sets[i])});
    readInstead(subject, values[i], name, draft);
    derived.push_back({Derived::Kind::TexCoord, sets[i], values[i]});
    written += (i == 0 ? "" : ", ") + subject.destination(values[i]);
    results += (i == 0 ? "" : ", ") + std::to_string(sets[i]);
  }
  const char *op = fp::ir::info(subject.at(values[0]).op).mnemonic;
  const std::string what =
      count == 1 ? std::string(op) + " is" : std::to_string(count) + " values are";
  Proposal proposal =
      draft.about(values[0], values[count - 1], "linear_work",
                  what + " linear in texture coordinates: the vertex stage can compute " +
                      (count == 1 ? "it" : "them") + ", and interpolation keeps that");
  proposal.derived = std::move(derived);
  proposal.application = "writes what " + written + (count == 1 ? " is" : " are") +
                         " here to result.texcoord " + results + " of its vertex program";
  return proposal;
}

constexpr const char *kOrder = "component_order";
constexpr const char *kOrderMessage =
    "the card has no such swizzle and copies for it: the components can come in this order";

/// Proposes an input with its components in the order that the operand reads.
std::optional<Proposal> orderOfInput(const Subject &subject, std::uint32_t index, int operand) {
  const fp::ir::Operand &source = subject.at(index).src[std::size_t(operand)];
  const bool attribute = source.file == File::Attribute;
  if (attribute && subject.program().attributes[source.index].kind != AttributeKind::TexCoord)
    return std::nullopt;
  std::string binding;
  Derived derived{Derived::Kind::TexCoord, 0, index, operand};
  if (attribute) {
    const std::vector<std::uint8_t> free = freeTexCoords(subject);
    if (free.empty())
      return std::nullopt;
    derived.index = free[0];
    binding = texCoordText(free[0]);
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
  proposal.application =
      "gives " + binding + " the components of " + subject.tokens(source.span) + " in this order";
  return proposal;
}

} // namespace

Proposals linearWork(const Subject &subject) {
  Proposals proposals;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    if (isLinear(subject, i))
      all.push_back(i);
  for (const std::uint32_t each : all)
    if (auto proposal = movedToVertices(subject, {each}))
      proposals.push_back(std::move(*proposal));
  // Moving all of them together may save a node.
  if (all.size() > 1)
    if (auto proposal = movedToVertices(subject, all))
      proposals.push_back(std::move(*proposal));
  return proposals;
}

Proposals operandOrder(const Subject &subject) {
  Proposals proposals;
  if (subject.program().language != fp::ir::Language::ArbFragment)
    return proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (int o = 0; o < fp::ir::info(subject.at(i).op).operandCount(); ++o) {
      const fp::ir::Operand &source = subject.at(i).src[std::size_t(o)];
      const bool parameter = source.file == File::Parameter && !source.relative &&
                             subject.flow().depends(i, o) == Depends::Parameter;
      if ((source.file != File::Attribute && !parameter) ||
          fp::ir::info(subject.at(i).op).shapes[o] == 'S' || subject.at(i).op == Opcode::Swz ||
          !isReordered(subject, i, o))
        continue;
      if (auto proposal = orderOfInput(subject, i, o))
        proposals.push_back(std::move(*proposal));
    }
  return proposals;
}

} // namespace arbiter::tools::advise
