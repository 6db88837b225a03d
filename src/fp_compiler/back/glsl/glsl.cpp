#include "fp_compiler/back/glsl/glsl.h"

#include "fp_compiler/back/glsl/arrays.h"
#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/back/glsl/helpers.h"
#include "fp_compiler/back/glsl/ranges.h"
#include "fp_compiler/back/glsl/registers.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::Instruction;
using ir::Opcode;

namespace {
std::string preamble(const ir::Options &options, const Registers &registers, const GlslHost &host) {
  std::string text = "#version 120\n";
  if (registers.readsRectangle() && host.textureRectangle)
    text += "#extension GL_ARB_texture_rectangle : enable\n";
  const bool conventions = options.originUpperLeft || options.pixelCenterInteger;
  if (!conventions || !registers.readsPosition() || !host.fragCoordConventions)
    return text;
  text += "#extension GL_ARB_fragment_coord_conventions : enable\nlayout(";
  if (options.originUpperLeft)
    text += "origin_upper_left";
  if (options.originUpperLeft && options.pixelCenterInteger)
    text += ", ";
  if (options.pixelCenterInteger)
    text += "pixel_center_integer";
  return text + ") varying vec4 gl_FragCoord;\n";
}

/// The fog options of 3.11.4.5.1: the blend of section 3.10 on the clamped colour. FOG's
/// enable and mode do not matter.
std::string fogFactor(ir::FogMode mode) {
  switch (mode) {
  case ir::FogMode::None:
    return "";
  case ir::FogMode::Exp: // e^-dc = 2^(-dc / ln 2)
    return "exp2(gl_Fog.density * gl_FogFragCoord * -1.442695041)";
  case ir::FogMode::Exp2:
    return "exp2(gl_Fog.density * gl_FogFragCoord * gl_Fog.density * gl_FogFragCoord * "
           "-1.442695041)";
  case ir::FogMode::Linear:
    // (e - c) / (e - s) as one multiplication and one addition, without a division a fragment;
    // hosts compute their own fog so, and where the form differs so does the last bit of the
    // colour.
    return "gl_Fog.end * gl_Fog.scale - gl_FogFragCoord * gl_Fog.scale";
  }
  return "";
}

/// Calls \p stage with the name of each colour that the program writes.
template <typename Stage>
std::string forEachColor(const ir::Program &program, const Registers &registers, Stage stage) {
  std::string text;
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == ir::OutputKind::Color)
      text += stage(registers.output(std::uint16_t(i)).name);
  return text;
}

/// Section 3.9, for programs whose language leaves it to fixed function.
std::string colorSum(const ir::Program &program, const Registers &registers) {
  if (!program.options.colorSum)
    return "";
  return forEachColor(program, registers, [](const std::string &color) {
    return "  " + color + ".rgb = clamp(" + color + ".rgb, 0.0, 1.0) + gl_SecondaryColor.rgb;\n";
  });
}

std::string fog(const ir::Program &program, const Registers &registers) {
  if (program.options.fog == ir::FogMode::None)
    return "";
  return "  float arb_fog = clamp(" + fogFactor(program.options.fog) + ", 0.0, 1.0);\n" +
         forEachColor(program, registers, [](const std::string &color) {
           return "  " + color + " = clamp(" + color + ", 0.0, 1.0);\n  " + color +
                  ".rgb = mix(gl_Fog.color.rgb, " + color + ".rgb, arb_fog);\n";
         });
}

/// ARB_position_invariant: the position as fixed function computes it, to the bit.
std::string invariantPosition(const ir::Program &program) {
  return program.options.positionInvariant ? "  gl_Position = ftransform();\n" : "";
}

/// User clip planes (2.11). A position-invariant program is clipped in eye space as fixed function
/// is. For others the specification has no clipping, but hosts clip them in clip space, by planes
/// taken through the projection, and programs have come to rely on it.
std::string clipVertex(const ir::Program &program, const GlslHost &host) {
  if (program.language != ir::Language::ArbVertex || !host.clipPlanes)
    return "";
  return program.options.positionInvariant
             ? "  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;\n"
             : "  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;\n";
}

class Body {
public:
  Body(const ir::Program &program, const Registers &registers)
      : m_program(program), m_registers(registers), m_ranges(program) {}

  std::string text() {
    std::string result;
    for (const Instruction &instruction : m_program.code) {
      result += statement(instruction);
      m_ranges.step(instruction);
    }
    return result;
  }

private:
  std::string statement(const Instruction &instruction) const {
    if (instruction.op == Opcode::Kil)
      return "  if (" + killCondition(m_registers, instruction.src[0]) + ") discard;\n";
    if (instruction.dst.file == ir::File::Address)
      return "  a" + std::to_string(instruction.dst.index) + " = " +
             expression(m_registers, instruction, {0}, {}) + ";\n";
    OutputText target;
    std::uint8_t mask = instruction.dst.mask;
    if (instruction.dst.file == ir::File::Temporary) {
      target.name = m_registers.temporary(instruction.dst.index);
    } else {
      target = m_registers.output(instruction.dst.index);
      mask &= ir::resultMask(m_program.outputs[instruction.dst.index].kind);
    }
    const Components components = positions(mask);
    if (components.empty())
      return "";
    std::string value =
        instruction.src[0].relative
            ? Arrays::element(instruction.src[0]) + suffix(components)
            : expression(m_registers, instruction, components, m_ranges.proofs(instruction));
    if (instruction.dst.saturate)
      value = "clamp(" + value + ", 0.0, 1.0)";
    return "  " + target.name + (target.scalar ? "" : suffix(components)) + " = " + value + ";\n";
  }

  const ir::Program &m_program;
  const Registers &m_registers;
  Ranges m_ranges;
};
} // namespace

GlslShader emit(const ir::Program &given, const GlslHost &host) {
  ir::Program program = given;
  hoistRelative(program);
  const Registers registers(program);
  GlslShader shader;
  shader.text = preamble(program.options, registers, host) + registers.declarations() +
                helpers(program) + "void main() {\n" + registers.locals() +
                invariantPosition(program) + Body(program, registers).text() +
                colorSum(program, registers) + fog(program, registers) + clipVertex(program, host) +
                "}\n";
  shader.uniforms = registers.uniforms();
  shader.samplers = registers.samplers();
  shader.attributes = registers.attributes();
  for (const Instruction &instruction : program.code)
    shader.kills |= instruction.op == Opcode::Kil;
  for (const ir::Output &output : program.outputs)
    shader.writesDepth |= output.kind == ir::OutputKind::Depth;
  return shader;
}

} // namespace arbiter::fp::glsl
