#include "fp_compiler/back/glsl/glsl.h"

#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/back/glsl/ranges.h"
#include "fp_compiler/back/glsl/registers.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::Instruction;
using ir::Opcode;

namespace {
const char *samplerType(ir::TexTarget target) {
  switch (target) {
  case ir::TexTarget::Tex1D:
    return "sampler1D";
  case ir::TexTarget::Tex2D:
    return "sampler2D";
  case ir::TexTarget::Tex3D:
    return "sampler3D";
  case ir::TexTarget::Cube:
    return "samplerCube";
  case ir::TexTarget::Rect:
    return "sampler2DRect";
  case ir::TexTarget::Shadow1D:
    return "sampler1DShadow";
  case ir::TexTarget::Shadow2D:
    return "sampler2DShadow";
  case ir::TexTarget::ShadowRect:
    return "sampler2DRectShadow";
  }
  return "";
}

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

std::string declarations(const Registers &registers) {
  std::string text;
  if (!registers.uniforms().empty())
    text += "uniform vec4 arb_param[" + std::to_string(registers.uniforms().size()) + "];\n";
  for (const GlslSampler &sampler : registers.samplers())
    text += std::string("uniform ") + samplerType(sampler.target) + " " + sampler.uniform + ";\n";
  return text;
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

std::string fog(const ir::Program &program, const Registers &registers) {
  if (program.options.fog == ir::FogMode::None)
    return "";
  std::string text = "  float arb_fog = clamp(" + fogFactor(program.options.fog) + ", 0.0, 1.0);\n";
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (program.outputs[i].kind != ir::OutputKind::Color)
      continue;
    const std::string &color = registers.output(std::uint16_t(i));
    text.append("  ").append(color).append(" = clamp(").append(color).append(", 0.0, 1.0);\n");
    text.append("  ").append(color).append(".rgb = mix(gl_Fog.color.rgb, ").append(color);
    text.append(".rgb, arb_fog);\n");
  }
  return text;
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
    std::string name;
    std::uint8_t mask = instruction.dst.mask;
    if (instruction.dst.file == ir::File::Temporary) {
      name = m_registers.temporary(instruction.dst.index);
    } else if (m_program.outputs[instruction.dst.index].kind == ir::OutputKind::Depth) {
      name = "gl_FragDepth";
      mask &= 4;
    } else {
      name = m_registers.output(instruction.dst.index);
    }
    if (mask == 0)
      return "";
    const Components components = positions(mask);
    std::string value =
        expression(m_registers, instruction, components, m_ranges.proofs(instruction));
    if (instruction.dst.saturate)
      value = "clamp(" + value + ", 0.0, 1.0)";
    const std::string where = name == "gl_FragDepth" ? "" : suffix(components);
    return "  " + name + where + " = " + value + ";\n";
  }

  const ir::Program &m_program;
  const Registers &m_registers;
  Ranges m_ranges;
};
} // namespace

GlslShader emit(const ir::Program &program, const GlslHost &host) {
  const Registers registers(program);
  GlslShader shader;
  shader.text = preamble(program.options, registers, host) + declarations(registers) +
                "void main() {\n" + registers.locals() + Body(program, registers).text() +
                fog(program, registers) + "}\n";
  shader.uniforms = registers.uniforms();
  shader.samplers = registers.samplers();
  for (const Instruction &instruction : program.code)
    shader.kills |= instruction.op == Opcode::Kil;
  for (const ir::Output &output : program.outputs)
    shader.writesDepth |= output.kind == ir::OutputKind::Depth;
  return shader;
}

} // namespace arbiter::fp::glsl
