#include "fp_compiler/back/llvm/program/prepare.h"

#include <algorithm>

#include "fp_compiler/analysis/affine_coordinates.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp::llvm_back {

namespace {
ir::Program optimised(ir::Program program, Numerics numerics) {
  opt::lowerOptions(program);
  opt::run(program, numerics);
  return program;
}

bool isInterpolated(const ir::Attribute &attribute) {
  return attribute.kind != ir::AttributeKind::Position &&
         attribute.kind != ir::AttributeKind::Facing;
}

std::vector<jit::FragmentInput> inputsOf(const ir::Program &program,
                                         const analysis::LiveValues &live) {
  std::vector<jit::FragmentInput> inputs;
  for (std::size_t i = 0; i < program.attributes.size(); ++i)
    if (live.attributes[i] != 0 && isInterpolated(program.attributes[i]))
      inputs.push_back({program.attributes[i], live.attributes[i]});
  return inputs;
}

void addSampler(std::vector<jit::Sampler> &samplers, const ir::Instruction &instruction) {
  const bool known =
      std::any_of(samplers.begin(), samplers.end(),
                  [&](const jit::Sampler &sampler) { return sampler.unit == instruction.unit; });
  if (!known)
    samplers.push_back({instruction.unit, instruction.target});
}

jit::FragmentShape shapeOf(const ir::Program &program) {
  const analysis::LiveValues live = analysis::liveOf(program);
  const std::vector<bool> curved = analysis::samplesCurved(program);
  jit::FragmentShape shape;
  shape.inputs = inputsOf(program, live);
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const ir::Instruction &instruction = program.code[i];
    const ir::OpInfo &row = ir::info(instruction.op);
    shape.kills |= row.has(ir::Kills);
    const bool derives = instruction.op == ir::Opcode::Ddx || instruction.op == ir::Opcode::Ddy;
    shape.derivatives |= derives && live.written[i] != 0;
    if (!row.has(ir::Texture) || live.written[i] == 0)
      continue;
    addSampler(shape.samplers, instruction);
    if (curved[i])
      shape.needsQuads |= 1u << instruction.unit;
  }
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (live.outputs[i] == 0)
      continue;
    if (program.outputs[i].kind == ir::OutputKind::Color)
      shape.colorOutputs |= std::uint8_t(1u << program.outputs[i].index);
    else if (program.outputs[i].kind == ir::OutputKind::Depth)
      shape.writesDepth = true;
  }
  return shape;
}

/// Adds a position output if the program has none, because later stages need one. The function
/// stores zeros for outputs and components that are not written. With a w of 0 nothing is drawn.
ir::Program withPosition(ir::Program program) {
  const ir::Output position = {ir::OutputKind::Position, 0};
  auto &outputs = program.outputs;
  if (std::find(outputs.begin(), outputs.end(), position) == outputs.end())
    outputs.push_back(position);
  return program;
}

jit::VertexShape vertexShapeOf(const ir::Program &program) {
  const analysis::LiveValues live = analysis::liveOf(program);
  jit::VertexShape shape;
  for (std::size_t i = 0; i < program.attributes.size(); ++i)
    if (live.attributes[i] != 0)
      shape.inputs.push_back(program.attributes[i]);
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (live.outputs[i] != 0 || program.outputs[i].kind == ir::OutputKind::Position)
      shape.outputs.push_back(program.outputs[i]);
  for (std::size_t i = 0; i < program.code.size(); ++i)
    if (ir::info(program.code[i].op).has(ir::Texture) && live.written[i] != 0)
      addSampler(shape.samplers, program.code[i]);
  return shape;
}
} // namespace

bool hasCode(const ir::Program &program) {
  return std::none_of(program.code.begin(), program.code.end(), [](const auto &instruction) {
    return ir::info(instruction.op).has(ir::Texture) && instruction.unit >= abi::kMaxUnits;
  });
}

PreparedFragment::PreparedFragment(ir::Program program, Numerics numerics)
    : m_program(optimised(std::move(program), numerics)), m_numerics(numerics),
      m_shape(shapeOf(m_program)) {}

PreparedVertex::PreparedVertex(ir::Program program, Numerics numerics)
    : m_program(withPosition(optimised(std::move(program), numerics))), m_numerics(numerics),
      m_shape(vertexShapeOf(m_program)) {}

} // namespace arbiter::fp::llvm_back
