#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::Instruction;
using ir::Opcode;
using ir::TexTarget;

namespace {
/// The functions that sample a target. A `projective` one takes the divisor as the last component.
/// Other targets need an explicit division. Shadow1D's second coordinate is unused.
struct TargetFunctions {
  const char *function;
  const char *projective; ///< nullptr: needs an explicit division
  bool bias;
};

TargetFunctions functionsOf(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
    return {"texture1D", "texture1DProj", true};
  case TexTarget::Tex2D:
    return {"texture2D", "texture2DProj", true};
  case TexTarget::Tex3D:
    return {"texture3D", nullptr, true};
  case TexTarget::Cube:
    return {"textureCube", nullptr, true};
  case TexTarget::Rect:
    return {"texture2DRect", nullptr, false};
  case TexTarget::Shadow1D:
    return {"shadow1D", "shadow1DProj", true};
  case TexTarget::Shadow2D:
    return {"shadow2D", "shadow2DProj", true};
  case TexTarget::ShadowRect:
    return {"shadow2DRect", nullptr, false};
  }
  return {"", nullptr, false};
}

/// Returns a sample with an explicit level of detail. TXD gives derivatives, and TXL the level. In
/// a vertex program others read the base level, except that TXB's bias is the level, as for TXL
/// (NV_vertex_program3 2.14.5.46).
std::string explicitSample(const Registers &registers, const Instruction &instruction,
                           const Components &coordinate) {
  const ir::Operand &operand = instruction.src[0];
  const TargetFunctions text = functionsOf(instruction.target);
  std::string at =
      "(arb_tex" + std::to_string(instruction.unit) + ", " + vector(registers, operand, coordinate);
  if (instruction.op == Opcode::Txp)
    at += " / " + component(registers, operand, 3);
  if (instruction.op == Opcode::Txd) {
    const Components changes = positions(ir::operandMask(instruction, 1));
    return std::string(text.function) + "GradARB" + at + ", " +
           vector(registers, instruction.src[1], changes) + ", " +
           vector(registers, instruction.src[2], changes) + ")";
  }
  if (!text.bias) // a rectangle texture has one level
    return text.function + at + ")";
  const bool given = instruction.op == Opcode::Txl || instruction.op == Opcode::Txb;
  return std::string(text.function) + "Lod" + at + ", " +
         (given ? component(registers, operand, 3) : "0.0") + ")";
}

std::string call(const Registers &registers, const Instruction &instruction) {
  const ir::Operand &operand = instruction.src[0];
  const TargetFunctions text = functionsOf(instruction.target);
  Components coordinate = positions(ir::coordinateMask(instruction.target));
  if (instruction.target == TexTarget::Shadow1D)
    coordinate = {0, 0, 2};
  if (instruction.op == Opcode::Txd || instruction.op == Opcode::Txl || registers.ofVertices())
    return explicitSample(registers, instruction, coordinate);
  const std::string sampler = "(arb_tex" + std::to_string(instruction.unit) + ", ";
  if (instruction.op == Opcode::Txp) {
    if (text.projective != nullptr) {
      Components projected = coordinate;
      projected.push_back(3);
      return text.projective + sampler + vector(registers, operand, projected) + ")";
    }
    return text.function + sampler + vector(registers, operand, coordinate) + " / " +
           component(registers, operand, 3) + ")";
  }
  const std::string bias =
      instruction.op == Opcode::Txb && text.bias ? ", " + component(registers, operand, 3) : "";
  return text.function + sampler + vector(registers, operand, coordinate) + bias + ")";
}
} // namespace

std::string sample(const Registers &registers, const Instruction &instruction) {
  const std::string read = call(registers, instruction);
  const bool alpha = (registers.alphaDepths() >> instruction.unit & 1u) != 0;
  return alpha ? "vec4(vec3(0.0), " + read + ".a)" : read;
}

} // namespace arbiter::fp::glsl
