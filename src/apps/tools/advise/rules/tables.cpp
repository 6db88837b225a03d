#include <algorithm>
#include <map>

#include "apps/tools/advise/rules/free_inputs.h"
#include "apps/tools/advise/rules/rules.h"
#include "fp_compiler/ir/reads.h"

/// Finds work that a texture lookup can replace: functions of one value, and normalized vectors.
namespace arbiter::tools::advise {

namespace {

/// One component of a register between two writes: of an attribute, or of an instruction's result.
struct Scalar {
  File file = File::Temporary;
  std::uint32_t index = 0; ///< number of the attribute or instruction
  std::uint8_t component = 0;
  auto operator<=>(const Scalar &) const = default;
};

/// An operand that reads the scalar, for its spelling.
struct Place {
  std::uint32_t instruction = 0;
  int operand = 0;
};

bool isFunction(Opcode op) {
  switch (op) {
  case Opcode::Pow:
  case Opcode::Ex2:
  case Opcode::Lg2:
  case Opcode::Rcp:
  case Opcode::Rsq:
  case Opcode::Sin:
  case Opcode::Cos:
  case Opcode::Scs:
  case Opcode::Lit:
    return true;
  default:
    return false;
  }
}

/// Returns the scalar that an operand reads, if it reads only one component.
std::optional<Scalar> scalarOf(const Subject &subject, std::uint32_t index, int operand) {
  const Instruction &instruction = subject.at(index);
  const fp::ir::Operand &source = instruction.src[std::size_t(operand)];
  const std::uint8_t read = componentsRead(source, fp::ir::operandMask(instruction, operand));
  if (read == 0 || (read & (read - 1)) != 0)
    return std::nullopt;
  std::uint8_t component = 0;
  while (!(read >> component & 1))
    ++component;
  if (source.file == File::Attribute)
    return Scalar{File::Attribute, source.index, component};
  const auto writer = subject.flow().writer(index, operand);
  return writer ? std::optional(Scalar{File::Temporary, *writer, component}) : std::nullopt;
}

/// Finds the instructions that are functions of one scalar. All their operands are parameters, the
/// scalar, or functions of it.
class Functions {
public:
  explicit Functions(const Subject &subject) : m_subject(subject), m_of(subject.size()) {}

  /// Follows one scalar through the program.
  /// \returns the instructions that are functions of it.
  std::vector<std::uint32_t> of(const Scalar &scalar) {
    std::vector<std::uint32_t> found;
    std::fill(m_of.begin(), m_of.end(), false);
    for (std::uint32_t i = 0; i < m_subject.size(); ++i) {
      m_of[i] = m_subject.flow().live(i) && isOf(i, scalar);
      if (m_of[i])
        found.push_back(i);
    }
    return found;
  }

  /// True if the result is a program result, or if a reader is no function of the scalar.
  [[nodiscard]] bool leaves(std::uint32_t index) const {
    const auto &uses = m_subject.flow().uses(index);
    return m_subject.at(index).dst.file != File::Temporary ||
           std::any_of(uses.begin(), uses.end(), [&](const Use &use) { return !m_of[use.reader]; });
  }

private:
  bool isOf(std::uint32_t index, const Scalar &scalar) const {
    const Instruction &instruction = m_subject.at(index);
    const fp::ir::OpInfo &row = fp::ir::info(instruction.op);
    if (row.has(fp::ir::Texture) || row.has(fp::ir::Kills) || row.has(fp::ir::VertexOnly))
      return false;
    bool any = false;
    for (int o = 0; o < operandsOf(instruction); ++o) {
      if (m_subject.flow().depends(index, o) <= Depends::Parameter)
        continue;
      const auto writer = m_subject.flow().writer(index, o);
      if (scalarOf(m_subject, index, o) != scalar && !(writer && m_of[*writer]))
        return false;
      any = true;
    }
    return any;
  }

  const Subject &m_subject;
  std::vector<bool> m_of;
};

/// Returns every scalar that an operand reads, with its first read.
std::map<Scalar, Place> scalarsOf(const Subject &subject) {
  std::map<Scalar, Place> places;
  for (std::uint32_t i = 0; i < subject.size(); ++i)
    for (int o = 0; o < operandsOf(subject.at(i)); ++o)
      if (const auto scalar = scalarOf(subject, i, o))
        places.try_emplace(*scalar, Place{i, o});
  return places;
}

Proposal tableProposal(const Subject &subject, const Place &place, std::uint32_t last,
                       std::uint8_t unit) {
  const fp::ir::Operand &source = subject.at(place.instruction).src[std::size_t(place.operand)];
  fp::ir::Operand plain = source;
  plain.negate = 0;
  const std::uint8_t mask = fp::ir::operandMask(subject.at(place.instruction), place.operand);
  const std::string value =
      *Subject::spelled(subject.base(place.instruction, place.operand), plain, mask, true);
  const std::string table = textureText(unit, fp::ir::TexTarget::Tex1D);
  Draft draft(subject);
  if (subject.flow().holds(source, mask, place.instruction, last)) {
    draft.replace(last,
                  statementText(Opcode::Tex, false, subject.destination(last), {value, table}));
  } else {
    const std::string name = subject.fresh("table");
    draft.insert(place.instruction,
                 {"TEMP " + name, statementText(Opcode::Tex, false, name, {value, table})});
    readInstead(subject, last, name, draft);
  }
  Proposal proposal = draft.about(last, "table_of_one_value",
                                  subject.destination(last) + " is a function of " + value +
                                      " alone: a one-dimensional texture can hold it");
  proposal.derived.push_back({Derived::Kind::Texture, unit, last});
  proposal.application = "fills a table for " + value +
                         " in [0,1] (scaled and biased where it is not) and binds it to "
                         "unit " +
                         std::to_string(unit) + "; eight bits are enough for colours";
  proposal.texture = true;
  return proposal;
}

bool isUnitVector(const Subject &subject, std::uint32_t scale, std::uint32_t &root,
                  std::uint32_t &square) {
  if (subject.at(scale).op != Opcode::Mul)
    return false;
  for (const int o : {0, 1}) {
    const auto rsq = subject.flow().writer(scale, o);
    if (!rsq || subject.at(*rsq).op != Opcode::Rsq)
      continue;
    const auto dot = subject.flow().writer(*rsq, 0);
    if (!dot || subject.at(*dot).op != Opcode::Dp3)
      continue;
    const fp::ir::Operand &v = subject.at(scale).src[std::size_t(1 - o)];
    const auto same = [&](const fp::ir::Operand &d) {
      return d.file == v.file && d.index == v.index && d.swizzle[0] == v.swizzle[0] &&
             d.swizzle[1] == v.swizzle[1] && d.swizzle[2] == v.swizzle[2];
    };
    if (same(subject.at(*dot).src[0]) && same(subject.at(*dot).src[1]) &&
        subject.flow().holds(v, 7, *dot, scale)) {
      root = *rsq;
      square = *dot;
      return true;
    }
  }
  return false;
}

} // namespace

Proposals tableOfOne(const Subject &subject) {
  Proposals proposals;
  const auto unit = freeUnit(subject);
  if (!unit || subject.program().language != fp::ir::Language::ArbFragment)
    return proposals;
  Functions functions(subject);
  for (const auto &[scalar, place] : scalarsOf(subject)) {
    if (scalar.file == File::Temporary &&
        subject.flow().depends(scalar.index) <= Depends::Parameter)
      continue;
    const std::vector<std::uint32_t> found = functions.of(scalar);
    if (std::none_of(found.begin(), found.end(),
                     [&](std::uint32_t i) { return isFunction(subject.at(i).op); }))
      continue;
    for (const std::uint32_t last : found)
      if (functions.leaves(last))
        proposals.push_back(tableProposal(subject, place, last, *unit));
  }
  return proposals;
}

Proposals cubeMap(const Subject &subject) {
  Proposals proposals;
  const auto unit = freeUnit(subject);
  if (!unit || subject.program().language != fp::ir::Language::ArbFragment)
    return proposals;
  for (std::uint32_t i = 0; i < subject.size(); ++i) {
    std::uint32_t root = 0, square = 0;
    if (!isUnitVector(subject, i, root, square) || (subject.at(i).dst.mask & 8) ||
        subject.flow().depends(square) <= Depends::Parameter)
      continue;
    fp::ir::Operand vector = subject.at(square).src[0];
    vector.negate = 0;
    const auto text = Subject::spelled(subject.base(square, 0), vector, 7, false);
    if (!text)
      continue;
    Draft draft(subject);
    draft.replace(i, statementText(Opcode::Tex, false, subject.destination(i),
                                   {*text, textureText(*unit, fp::ir::TexTarget::Cube)}));
    Proposal proposal = draft.about(
        square, i, "unit_vector_cube_map",
        "DP3, RSQ and MUL make a vector's length 1: a cube map can hold all unit vectors");
    proposal.derived.push_back({Derived::Kind::Texture, *unit, i});
    proposal.application = "binds a cube map of unit vectors, in a signed format, to unit " +
                           std::to_string(*unit) +
                           "; in an unsigned one they are halved and biased, which a MAD undoes";
    proposal.texture = true;
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

} // namespace arbiter::tools::advise
