#include "fp_compiler/fixed_function.h"

#include <algorithm>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp {

namespace {

/// Returns the parameter with an incomplete texture's value, and adds it if there is none.
std::uint16_t incompleteTexture(ir::Program &program) {
  constexpr ir::Vec4 kValue = {0, 0, 0, 1};
  for (std::size_t i = 0; i < program.parameters.size(); ++i)
    if (program.parameters[i].kind == ir::ParameterKind::Constant &&
        program.parameters[i].constant == kValue)
      return std::uint16_t(i);
  program.parameters.push_back({.kind = ir::ParameterKind::Constant, .constant = kValue});
  return std::uint16_t(program.parameters.size() - 1);
}

/// Replaces a sample by a copy of an incomplete texture's value.
void sampleNothing(ir::Program &program, ir::Instruction &sample) {
  sample.op = ir::Opcode::Mov;
  sample.src[0] = {};
  sample.src[0].file = ir::File::Parameter;
  sample.src[0].index = incompleteTexture(program);
  sample.src[0].span = sample.span;
}

} // namespace

ir::Program withFixedFunction(ir::Program program, const FixedFunction &state) {
  for (ir::Instruction &instruction : program.code) {
    if (!ir::info(instruction.op).has(ir::Texture) || instruction.unit >= state.targets.size())
      continue;
    if ((state.disabledUnits >> instruction.unit & 1u) != 0) {
      sampleNothing(program, instruction);
      continue;
    }
    instruction.target = state.targets[instruction.unit];
    program.options.shadow |= ir::isShadow(instruction.target);
  }
  program.options.fog = state.fog;
  program.options.colorSum = state.colorSum;
  return program;
}

namespace {

std::uint16_t indexOf(std::vector<ir::Attribute> &attributes, ir::Attribute attribute) {
  const auto it = std::find(attributes.begin(), attributes.end(), attribute);
  const auto index = std::uint16_t(it - attributes.begin());
  if (it == attributes.end())
    attributes.push_back(attribute);
  return index;
}

/// Collects the colour in a temporary. Appends code that clamps it and adds the secondary colour's
/// rgb.
void addSecondaryColor(ir::Program &program) {
  const auto sum = std::uint16_t(program.temporaries.size());
  program.temporaries.push_back({"sum"});
  std::uint16_t color = 0;
  for (ir::Instruction &instruction : program.code) {
    if (ir::info(instruction.op).has(ir::Kills) || instruction.dst.file != ir::File::Output ||
        program.outputs[instruction.dst.index].kind != ir::OutputKind::Color)
      continue;
    color = instruction.dst.index;
    instruction.dst.file = ir::File::Temporary;
    instruction.dst.index = sum;
  }
  const ir::Operand gathered = {.file = ir::File::Temporary, .index = sum};
  const ir::Operand secondary = {
      .file = ir::File::Attribute,
      .index = indexOf(program.attributes, {ir::AttributeKind::ColorSecondary})};
  const auto append = [&](ir::Opcode op, ir::Destination dst, const ir::Operand &a,
                          const ir::Operand &b) {
    ir::Instruction instruction;
    instruction.op = op;
    instruction.dst = dst;
    instruction.src = {a, b};
    program.code.push_back(instruction);
  };
  append(ir::Opcode::Mov, {.file = ir::File::Temporary, .index = sum, .saturate = true}, gathered,
         {});
  append(ir::Opcode::Add, {.file = ir::File::Output, .index = color, .mask = 7}, gathered,
         secondary);
  append(ir::Opcode::Mov, {.file = ir::File::Output, .index = color, .mask = 8}, gathered, {});
}

} // namespace

ir::Program asArbFragment(ir::Program program) {
  program.language = ir::Language::ArbFragment;
  const bool colored =
      std::any_of(program.outputs.begin(), program.outputs.end(),
                  [](const ir::Output &output) { return output.kind == ir::OutputKind::Color; });
  if (program.options.colorSum && colored)
    addSecondaryColor(program);
  program.options.colorSum = false;
  return program;
}

} // namespace arbiter::fp
