#include <utility>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/opt/opt.h"

namespace arbiter::fp::opt {

using ir::Opcode;
using ir::Source;
using ir::Target;

namespace {

/// A colour result, and the temporary that the code writes in its place.
struct Color {
  Target result, gathered;
};

std::vector<Color> gatherColors(ir::Program &program) {
  std::vector<Color> colors;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (program.outputs[i].kind != ir::OutputKind::Color)
      continue;
    Color color;
    color.result.file = ir::File::Output;
    color.result.index = std::uint16_t(i);
    color.gathered.index = std::uint16_t(program.temporaries.size());
    program.temporaries.push_back({"color"});
    for (ir::Instruction &instruction : program.code)
      if (ir::info(instruction.op).hasDestination() && instruction.dst.file == ir::File::Output &&
          instruction.dst.index == i) {
        instruction.dst.file = ir::File::Temporary;
        instruction.dst.index = color.gathered.index;
      }
    colors.push_back(color);
  }
  return colors;
}

void addSecondary(ir::Builder &builder, const std::vector<Color> &colors) {
  const Source secondary = builder.attribute(ir::AttributeKind::ColorSecondary);
  for (const Color &color : colors) {
    const Target rgb = color.gathered.mask("xyz");
    builder.op(Opcode::Mov, rgb.sat(), {rgb.read()});
    builder.op(Opcode::Add, rgb, {rgb.read(), secondary});
  }
}

/// Returns the fog factor, by the equations of ir/fog.h.
Source fogFactor(ir::Builder &builder, ir::FogMode mode, bool isOfMagnitude) {
  const Target factor = builder.temporary("fog").mask("x");
  const Source value = factor.read().swz("x");
  const Source row = builder.state({.item = ir::StateItem::FogFactors});
  Source coordinate = builder.attribute(ir::AttributeKind::FogCoord).swz("x");
  if (isOfMagnitude) {
    builder.op(Opcode::Abs, factor, {coordinate});
    coordinate = value;
  }
  switch (mode) {
  case ir::FogMode::None:
    break;
  case ir::FogMode::Exp:
    builder.op(Opcode::Mul, factor, {coordinate, row.swz("z")});
    builder.op(Opcode::Ex2, factor.sat(), {value});
    break;
  case ir::FogMode::Exp2:
    builder.op(Opcode::Mul, factor, {coordinate, row.swz("w")});
    builder.op(Opcode::Mul, factor, {value, value});
    builder.op(Opcode::Ex2, factor.sat(), {-value});
    break;
  case ir::FogMode::Linear:
    builder.op(Opcode::Mad, factor.sat(), {coordinate, row.swz("x"), row.swz("y")});
    break;
  }
  return value;
}

void blendFog(ir::Builder &builder, const std::vector<Color> &colors, const Source &factor) {
  const Source fog = builder.state({.item = ir::StateItem::FogColor});
  for (const Color &color : colors) {
    const Source clamped = color.gathered.read();
    builder.op(Opcode::Mov, color.gathered.sat(), {clamped});
    builder.op(Opcode::Lrp, color.gathered.mask("xyz"), {factor, clamped, fog});
  }
}

} // namespace

bool lowerOptions(ir::Program &program, const OptionTarget &target) {
  const bool sums = std::exchange(program.options.colorSum, false);
  const ir::FogMode mode =
      target.hasFog ? ir::FogMode::None : std::exchange(program.options.fog, ir::FogMode::None);
  if (!sums && mode == ir::FogMode::None)
    return false;
  const std::vector<Color> colors = gatherColors(program);
  ir::Builder builder(std::move(program));
  if (sums)
    addSecondary(builder, colors);
  if (mode != ir::FogMode::None)
    blendFog(builder, colors, fogFactor(builder, mode, target.hasNegativeFogDistances));
  for (const Color &color : colors)
    builder.op(Opcode::Mov, color.result, {color.gathered.read()});
  program = builder.take();
  return true;
}

} // namespace arbiter::fp::opt
