// Adds parts of fixed function to an application's vertex program.
#include <algorithm>
#include <initializer_list>

#include "fp_compiler/ir/ir.h"
#include "state/raster_draw/fixed_function/fixed_vertex.h"

namespace arbiter::state {

namespace {

using fp::ir::File;
using fp::ir::Instruction;
using fp::ir::MatrixModifier;
using fp::ir::Opcode;
using fp::ir::Operand;
using fp::ir::OutputKind;
using fp::ir::Program;
using fp::ir::StateItem;

/// Appends instructions to the end of a program.
class Appender {
public:
  explicit Appender(Program &program) : m_program(program) {}

  std::uint16_t output(const fp::ir::Output &wanted) { return find(m_program.outputs, wanted); }
  Operand attribute(const fp::ir::Attribute &wanted) {
    return operand(File::Attribute, find(m_program.attributes, wanted));
  }
  Operand state(StateItem item, int index, int row, MatrixModifier modifier) {
    fp::ir::Parameter parameter;
    parameter.kind = fp::ir::ParameterKind::State;
    parameter.state.item = item;
    parameter.state.index = std::uint8_t(index);
    parameter.state.row = std::uint8_t(row);
    parameter.state.modifier = modifier;
    m_program.parameters.push_back(parameter);
    return operand(File::Parameter, std::uint16_t(m_program.parameters.size() - 1));
  }
  std::uint16_t temporary(const char *name) {
    m_program.temporaries.push_back({name});
    return std::uint16_t(m_program.temporaries.size() - 1);
  }
  struct Redirected {
    std::uint16_t temporary;
    std::uint8_t mask; ///< the components that are written
  };
  /// Makes a temporary that replaces the output in the program's instructions.
  Redirected redirected(std::uint16_t output, const char *name) {
    Redirected result{temporary(name), 0};
    for (Instruction &instruction : m_program.code) {
      fp::ir::Destination &to = instruction.dst;
      if (to.file != File::Output || to.index != output)
        continue;
      to.file = File::Temporary;
      to.index = result.temporary;
      result.mask |= to.mask;
    }
    return result;
  }
  static Operand operand(File file, std::uint16_t index) {
    Operand result;
    result.file = file;
    result.index = index;
    return result;
  }
  void op(Opcode opcode, File file, std::uint16_t index, unsigned mask,
          std::initializer_list<Operand> sources) {
    Instruction instruction;
    instruction.op = opcode;
    instruction.dst.file = file;
    instruction.dst.index = index;
    instruction.dst.mask = std::uint8_t(mask);
    std::copy(sources.begin(), sources.end(), instruction.src.begin());
    m_program.code.push_back(instruction);
  }
  void transform(File file, std::uint16_t index, StateItem matrix, MatrixModifier modifier,
                 const Operand &vector) {
    for (int row = 0; row < 4; ++row)
      op(Opcode::Dp4, file, index, 1u << row, {state(matrix, 0, row, modifier), vector});
  }

private:
  template <typename Row> static std::uint16_t find(std::vector<Row> &rows, const Row &wanted) {
    const auto found = std::find(rows.begin(), rows.end(), wanted);
    const auto index = std::uint16_t(found - rows.begin());
    if (found == rows.end())
      rows.push_back(wanted);
    return index;
  }
  Program &m_program;
};

bool isColor(OutputKind kind) {
  return kind == OutputKind::FrontPrimary || kind == OutputKind::FrontSecondary ||
         kind == OutputKind::BackPrimary || kind == OutputKind::BackSecondary;
}

void clampColors(Program &program) {
  for (Instruction &instruction : program.code)
    if (instruction.dst.file == File::Output &&
        isColor(program.outputs[instruction.dst.index].kind))
      instruction.dst.saturate = true;
}

/// Clamps colours so that NaN becomes 1. A saturating instruction would give 0.
void clampColorsToOne(Program &program) {
  Appender append(program);
  for (std::size_t output = 0; output < program.outputs.size(); ++output) {
    if (!isColor(program.outputs[output].kind))
      continue;
    const auto [color, mask] = append.redirected(std::uint16_t(output), "color");
    if (mask == 0)
      continue;
    const Operand value = Appender::operand(File::Temporary, color);
    Operand one = value;
    one.swizzle.fill(fp::ir::Select::One);
    append.op(Opcode::Min, File::Output, std::uint16_t(output), mask, {value, one});
    program.code.back().dst.saturate = true;
  }
}

/// Writes clip distances for the position that is drawn, transformed back by the projection.
/// Positions of fixed function, of an invariant program, and of a program that computes the same
/// are thus clipped at the same bits. Hosts do the same in clip space, with planes transformed by
/// the projection. For programs without ARB_position_invariant, the specification defines no
/// clipping by user planes at all.
void addClipDistances(Appender &append, std::uint8_t planes, std::uint16_t position) {
  const std::uint16_t eye = append.temporary("eye");
  append.transform(File::Temporary, eye, StateItem::MatrixProjection, MatrixModifier::Inverse,
                   Appender::operand(File::Temporary, position));
  for (int plane = 0; plane < 8; ++plane)
    if ((planes >> plane & 1u) != 0)
      append.op(
          Opcode::Dp4, File::Output,
          append.output({OutputKind::TexCoord, std::uint8_t(kClipDistanceOutput + plane / 4)}),
          1u << plane % 4,
          {append.state(StateItem::ClipPlane, plane, 0, MatrixModifier::Plain),
           Appender::operand(File::Temporary, eye)});
}

void addInvariantPosition(Program &program) {
  program.options.positionInvariant = false;
  Appender append(program);
  const Operand vertex = append.attribute({fp::ir::AttributeKind::Position, 0});
  append.transform(File::Output, append.output({OutputKind::Position, 0}), StateItem::MatrixMvp,
                   MatrixModifier::Plain, vertex);
}

void clipPosition(Program &program, std::uint8_t planes) {
  const auto found = std::find(program.outputs.begin(), program.outputs.end(),
                               fp::ir::Output{OutputKind::Position, 0});
  if (found == program.outputs.end())
    return;
  const auto output = std::uint16_t(found - program.outputs.begin());
  Appender append(program);
  const std::uint16_t position = append.redirected(output, "position").temporary;
  const Operand value = Appender::operand(File::Temporary, position);
  append.op(Opcode::Mov, File::Output, output, 0xF, {value});
  addClipDistances(append, planes, position);
}

} // namespace

Program withFixedPosition(Program program, std::uint8_t clipPlanes, ColorClamp clamp) {
  if (clamp == ColorClamp::NanIsZero)
    clampColors(program);
  if (clamp == ColorClamp::NanIsOne)
    clampColorsToOne(program);
  // With NVIDIA's options, a program clips by distances that it writes, or by the planes if it is
  // position-invariant.
  const bool ownDistances = program.options.clipsByDistances();
  if (program.options.positionInvariant)
    addInvariantPosition(program);
  if (clipPlanes != 0 && !ownDistances)
    clipPosition(program, clipPlanes);
  return program;
}

const std::shared_ptr<const Program> &
ExtendedPrograms::get(const std::shared_ptr<const Program> &program, std::uint8_t clipPlanes,
                      ColorClamp clamp) {
  const Key key = {program.get(), clipPlanes, clamp};
  const auto found = m_programs.find(key);
  if (found != m_programs.end()) [[likely]]
    return found->second.extended;
  if (m_programs.size() >= m_sweepAt)
    sweep();
  Entry entry;
  entry.program = program;
  entry.extended = std::make_shared<const Program>(withFixedPosition(*program, clipPlanes, clamp));
  return m_programs.emplace(key, std::move(entry)).first->second.extended;
}

/// Drops programs that nothing else holds.
void ExtendedPrograms::sweep() {
  std::unordered_map<const Program *, long> held;
  for (const auto &[key, entry] : m_programs)
    ++held[key.program];
  std::erase_if(m_programs, [&](const auto &row) {
    return row.second.program.use_count() == held[row.first.program];
  });
  m_sweepAt = std::max<std::size_t>(64, 2 * m_programs.size());
}

} // namespace arbiter::state
