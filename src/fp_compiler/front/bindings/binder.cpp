#include "fp_compiler/front/bindings/binder.h"

#include <algorithm>
#include <bit>

#include "fp_compiler/ir/print.h"

namespace arbiter::fp {

namespace {

/// Returns the index of an equal row. Appends the row if there is none. Only for lists of bounded
/// length.
template <typename T> std::uint16_t findOrAppend(std::vector<T> &rows, const T &row, bool &isNew) {
  const auto found = std::find(rows.begin(), rows.end(), row);
  isNew = found == rows.end();
  const auto index = std::uint16_t(found - rows.begin());
  if (isNew)
    rows.push_back(row);
  return index;
}

std::uint64_t keyOf(ir::ParameterKind kind, std::uint64_t rest) {
  return std::uint64_t(kind) << 56 | rest;
}

/// Returns the generic attribute in the same row of table X.2.1 (ARB_vertex_program 2.14.3.1).
int genericOf(ir::Attribute attribute) {
  switch (attribute.kind) {
  case ir::AttributeKind::Position:
    return 0;
  case ir::AttributeKind::Normal:
    return 2;
  case ir::AttributeKind::ColorPrimary:
    return 3;
  case ir::AttributeKind::ColorSecondary:
    return 4;
  case ir::AttributeKind::FogCoord:
    return 5;
  case ir::AttributeKind::TexCoord:
    return 8 + attribute.index;
  case ir::AttributeKind::Generic:
    return attribute.index;
  case ir::AttributeKind::Facing:
    break; // of fragments
  }
  return -1;
}

} // namespace

std::size_t Binder::BitsHash::operator()(const Bits &bits) const {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (std::uint32_t part : bits) {
    h = (h ^ part) * 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  }
  return std::size_t(h);
}

Binder::Bits Binder::countedBits(const ir::Vec4 &value) {
  Bits bits;
  for (std::size_t i = 0; i < 4; ++i)
    bits[i] = value[i] == 0 ? 0 : std::bit_cast<std::uint32_t>(value[i]);
  return bits;
}

Binder::Binder(ir::Language language, const CompileOptions &options, Reporter &reporter)
    : m_reporter(reporter), m_budget(options, reporter) {
  m_program.language = language;
  m_program.code.reserve(32);
  m_program.parameters.reserve(16);
  // Every fragment program has one node, even without texture instructions.
  if (language != ir::Language::ArbVertex)
    m_budget.spend(Resource::TexIndirections, {});
}

void Binder::setOptions(const ir::Options &options) {
  m_program.options = options;
  m_budget.debit(options);
}

std::uint16_t Binder::temporary(std::string_view name, Span where) {
  if (!m_budget.spend(Resource::Temporaries, where))
    return 0;
  m_program.temporaries.push_back({std::string(name)});
  return std::uint16_t(m_program.temporaries.size() - 1);
}

std::uint16_t Binder::addressRegister(std::string_view name, Span where) {
  if (!m_budget.spend(Resource::AddressRegisters, where))
    return 0;
  m_program.addresses.push_back({std::string(name)});
  return std::uint16_t(m_program.addresses.size() - 1);
}

std::uint16_t Binder::attribute(ir::Attribute attribute, Span where, bool alone) {
  bool isNew = false;
  const std::uint16_t index = findOrAppend(m_program.attributes, attribute, isNew);
  if (!isNew)
    return index;
  if (alone) // else the whole file is there to choose from
    m_budget.spend(Resource::Attribs, where);
  if (m_program.language == ir::Language::ArbVertex && alone)
    refuseAlias(attribute, where);
  return index;
}

/// Reports an error if a conventional attribute and the generic one of its row are both bound.
void Binder::refuseAlias(ir::Attribute attribute, Span where) {
  for (const ir::Attribute &other : m_program.attributes)
    if (!(other == attribute) && genericOf(other) == genericOf(attribute))
      m_reporter.error(DiagnosticId::AttributeAlias, where,
                       bindingText(attribute, m_program.language) + " is bound beside " +
                           bindingText(other, m_program.language),
                       "the two may share their storage: a program binds one of them");
}

std::uint16_t Binder::output(ir::Output output) {
  bool isNew = false;
  return findOrAppend(m_program.outputs, output, isNew);
}

std::uint16_t Binder::append(const ir::Parameter &parameter) {
  m_program.parameters.push_back(parameter);
  return std::uint16_t(m_program.parameters.size() - 1);
}

std::uint16_t Binder::row(std::uint64_t key, const ir::Parameter &parameter, Span where) {
  const auto [entry, isNew] = m_stateRows.try_emplace(key, std::uint16_t(0));
  if (isNew && m_budget.spend(Resource::Parameters, where))
    entry->second = append(parameter);
  return entry->second;
}

std::uint16_t Binder::constant(const ir::Vec4 &value, Span where) {
  return constantRow(value, where, true);
}

std::uint16_t Binder::hiddenConstant(const ir::Vec4 &value, Span where) {
  return constantRow(value, where, false);
}

std::uint16_t Binder::constantRow(const ir::Vec4 &value, Span where, bool counts) {
  Bits bits;
  for (std::size_t i = 0; i < 4; ++i)
    bits[i] = std::bit_cast<std::uint32_t>(value[i]);
  const auto [entry, isNew] = m_constantRows.try_emplace(bits, std::uint16_t(0));
  if (!isNew)
    return entry->second;
  // A zero of the other sign gets its own row but is not counted again. It must still stay below
  // the ceiling.
  if (counts && m_constantsCounted.insert(countedBits(value)).second &&
      !m_budget.spend(Resource::Parameters, where))
    return 0;
  if (m_program.parameters.size() >= Budget::kCeiling) {
    m_reporter.error(DiagnosticId::LimitParameters, where, "too many constants in any program");
    return 0;
  }
  ir::Parameter parameter;
  parameter.constant = value;
  return entry->second = append(parameter);
}

std::uint16_t Binder::env(std::uint32_t index, Span where) {
  ir::Parameter parameter;
  parameter.kind = ir::ParameterKind::Env;
  parameter.index = std::uint16_t(index);
  return row(keyOf(parameter.kind, index), parameter, where);
}

std::uint16_t Binder::hiddenEnv(std::uint32_t index, Span where) {
  const auto [entry, isNew] =
      m_stateRows.try_emplace(keyOf(ir::ParameterKind::Env, index), std::uint16_t(0));
  if (isNew && m_program.parameters.size() >= Budget::kCeiling) {
    m_reporter.error(DiagnosticId::LimitParameters, where, "too many parameters in any program");
  } else if (isNew) {
    ir::Parameter parameter;
    parameter.kind = ir::ParameterKind::Env;
    parameter.index = std::uint16_t(index);
    entry->second = append(parameter);
  }
  return entry->second;
}

std::uint16_t Binder::local(std::uint32_t index, Span where) {
  ir::Parameter parameter;
  parameter.kind = ir::ParameterKind::Local;
  parameter.index = std::uint16_t(index);
  return row(keyOf(parameter.kind, index), parameter, where);
}

std::uint16_t Binder::state(const ir::StateRef &ref, Span where) {
  ir::Parameter parameter;
  parameter.kind = ir::ParameterKind::State;
  parameter.state = ref;
  const std::uint64_t key = std::uint64_t(ref.item) << 32 | std::uint64_t(ref.back) << 24 |
                            std::uint64_t(ref.index) << 16 | std::uint64_t(ref.modifier) << 8 |
                            ref.row;
  return row(keyOf(parameter.kind, key), parameter, where);
}

std::uint16_t Binder::relativeArray(std::string_view name, const std::vector<std::uint16_t> &rows,
                                    Span where) {
  bool reported = false;
  for (const std::uint16_t row : rows) {
    if (row >= m_program.parameters.size())
      continue; // over the ceiling, which is reported
    const ir::Parameter &parameter = m_program.parameters[row];
    if (parameter.kind == ir::ParameterKind::Constant) {
      // Each distinct value was already counted where it was bound.
      if (!m_relativeConstants.insert(countedBits(parameter.constant)).second)
        m_budget.spend(Resource::Parameters, where);
    } else if (!m_relativeState.insert(row).second && !reported) {
      reported = true;
      m_reporter.error(DiagnosticId::RelativeDuplicate, where,
                       "a state vector is bound twice in arrays that are indexed by an address "
                       "register",
                       "bind each program.* and state.* vector once in such arrays");
    }
  }
  m_program.arrays.push_back({std::string(name), rows});
  return std::uint16_t(m_program.arrays.size() - 1);
}

/// Counts the resources that only fragment programs have.
bool Binder::countKinds(const ir::Instruction &instruction, Span opcode) {
  const ir::OpInfo &op = info(instruction.op);
  const bool isTexture = op.has(ir::Texture) || op.has(ir::Kills);
  bool fits =
      m_budget.spend(isTexture ? Resource::TexInstructions : Resource::AluInstructions, opcode);
  if (m_indirections.add(instruction))
    fits &= m_budget.spend(Resource::TexIndirections, opcode);
  return fits;
}

bool Binder::count(const ir::Instruction &instruction, Span opcode) {
  bool fits = m_budget.spend(Resource::Instructions, opcode);
  if (m_program.language != ir::Language::ArbVertex)
    fits &= countKinds(instruction, opcode);
  return fits;
}

void Binder::instruction(const ir::Instruction &instruction, Span opcode) {
  if (count(instruction, opcode) && !m_reporter.hasErrors())
    m_program.code.push_back(instruction);
}

std::uint16_t Binder::hiddenTemporary(std::string_view name, Span where) {
  if (m_program.temporaries.size() >= Budget::kCeiling) {
    m_reporter.error(DiagnosticId::LimitTemporaries, where, "too many temporaries in any program");
    return 0;
  }
  m_program.temporaries.push_back({std::string(name)});
  return std::uint16_t(m_program.temporaries.size() - 1);
}

std::uint16_t Binder::addressVector(std::string_view name, Span where) {
  constexpr std::size_t kMax = 256; // operands number them in eight bits
  const bool fits = m_budget.spend(Resource::AddressRegisters, where);
  if (fits && m_program.addresses.size() + 4 > kMax)
    m_reporter.error(DiagnosticId::LimitAddressRegisters, where,
                     "more than 64 address registers in any program");
  if (!fits || m_program.addresses.size() + 4 > kMax)
    return 0;
  const auto first = std::uint16_t(m_program.addresses.size());
  for (const char letter : {'x', 'y', 'z', 'w'})
    m_program.addresses.push_back({std::string(name) + "." + letter});
  return first;
}

void Binder::append(const ir::Instruction &instruction, Span where) {
  // A host's GLSL compiler may recurse along a chain of instructions. Mesa's overflowed its stack
  // with a chain of 16,000.
  constexpr std::size_t kMax = 10000;
  if (m_program.code.size() >= kMax)
    return m_reporter.error(DiagnosticId::LimitInstructions, where,
                            "too many instructions in any program, subroutines written out",
                            "call fewer of them");
  m_program.code.push_back(instruction);
}

} // namespace arbiter::fp
