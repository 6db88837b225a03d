#include "fp_compiler/back/glsl/glsl.h"

#include <algorithm>

#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/glsl/arrays.h"
#include "fp_compiler/back/glsl/expression.h"
#include "fp_compiler/back/glsl/helpers.h"
#include "fp_compiler/back/glsl/registers.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::glsl {

using analysis::RangeAnalysis;
using ir::Instruction;
using ir::Opcode;

namespace {
/// GLSL extensions that a program's opcodes need.
struct Needs {
  bool bits = false;      ///< PK*, UP*
  bool lod = false;       ///< TXD, and TXL of a fragment program
  bool vertexLod = false; ///< texture samples in a vertex program; GLSL 1.20 has them
};

Needs needsOf(const ir::Program &program) {
  Needs needs;
  for (const Instruction &instruction : program.code) {
    const bool added = int(instruction.op) >= ir::kOpcodeCount;
    needs.bits |= added && ir::carriesBits(instruction.op);
    const bool vertex = program.language == ir::Language::ArbVertex;
    needs.lod |= instruction.op == Opcode::Txd || (instruction.op == Opcode::Txl && !vertex);
    needs.vertexLod |= vertex && ir::info(instruction.op).has(ir::Texture);
  }
  return needs;
}

/// True if the program's clip results are distances from planes (NV_vertex_program2_option, section
/// 2.11).
bool hasClipDistances(const ir::Program &program, const GlslHost &host) {
  return program.language == ir::Language::ArbVertex && program.options.clipsByDistances() &&
         host.clipPlanes && host.clipDistances != 0;
}

std::string preamble(const ir::Program &program, const Registers &registers, const GlslHost &host,
                     Numerics numerics) {
  const ir::Options &options = program.options;
  const Needs needs = needsOf(program);
  std::string text = hasClipDistances(program, host) ? "#version 130\n" : "#version 120\n";
  // This cannot be GLSL 1.30, because hosts then ignore DEPTH_TEXTURE_MODE.
  if (numerics == Numerics::Fp24 || needs.bits)
    text += "#extension GL_EXT_gpu_shader4 : require\n"
            "#extension GL_ARB_shader_bit_encoding : require\n";
  if (needs.lod || needs.vertexLod)
    text += std::string("#extension GL_ARB_shader_texture_lod : ") +
            (needs.lod ? "require\n" : "enable\n");
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

/// Returns the fog distance. It is the absolute value if the host's fixed function passes negative
/// distances.
std::string fogDistance(const GlslHost &host) {
  return host.negativeFogDistances ? "abs(gl_FogFragCoord)" : "gl_FogFragCoord";
}

/// Returns the fog factor of the fog options (3.11.4.5.1), which blend as in section 3.10 with the
/// clamped colour. FOG's enable and mode do not matter.
std::string fogFactor(ir::FogMode mode, Numerics numerics, const std::string &distance) {
  const bool host = numerics == Numerics::Host;
  switch (mode) {
  case ir::FogMode::None:
    return "";
  case ir::FogMode::Exp: // e^-dc = 2^(-dc / ln 2)
    return host ? "exp2(gl_Fog.density * " + distance + " * -1.442695041)"
                : "exp2(arb_mul(gl_Fog.density * -1.442695041, " + distance + "))";
  case ir::FogMode::Exp2: {
    const std::string product = "arb_mul(gl_Fog.density, " + distance + ")";
    return host ? "exp2(gl_Fog.density * " + distance + " * gl_Fog.density * " + distance +
                      " * -1.442695041)"
                : "exp2(" + product + " * " + product + " * -1.442695041)";
  }
  case ir::FogMode::Linear:
    // This is (e - c) / (e - s) as one multiplication and one addition, without a division in each
    // fragment. Hosts compute their own fog this way, and another form would differ in the last
    // bit.
    return "gl_Fog.end * gl_Fog.scale - " + distance + " * gl_Fog.scale";
  }
  return "";
}

/// Returns the fog factor in the R300's steps (ir/semantics.h). It reads the locals of
/// fogLocals24().
std::string fogFactor24(ir::FogMode mode) {
  const char *const factor =
      mode == ir::FogMode::Linear
          ? "arb_round(arb_fogscaled + arb_truncate(gl_Fog.end * gl_Fog.scale))"
      : mode == ir::FogMode::Exp ? "arb_round(exp2(-arb_fogscaled))"
                                 : "arb_round(exp2(-arb_round(arb_fogscaled * arb_fogscaled)))";
  return factor;
}

std::string fogLocals24(ir::FogMode mode, const std::string &distance) {
  const char *const row = mode == ir::FogMode::Linear ? "-gl_Fog.scale"
                          : mode == ir::FogMode::Exp  ? "gl_Fog.density * 1.442695041"
                                                      : "gl_Fog.density * 1.201122409";
  return "  float arb_fogscaled = arb_round(arb_mul(arb_round(" + distance + "), arb_truncate(" +
         row + ")));\n  vec3 arb_fogcolor = arb_truncate(gl_Fog.color.rgb);\n";
}

/// Concatenates the results of \p stage for each colour that the program writes.
template <typename Stage>
std::string forEachColor(const ir::Program &program, const Registers &registers, Stage stage) {
  std::string text;
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i].kind == ir::OutputKind::Color)
      text += stage(registers.output(std::uint16_t(i)).name);
  return text;
}

/// Returns the colour sum (section 3.9), for languages that leave it to fixed function.
std::string colorSum(const ir::Program &program, const Registers &registers, Numerics numerics) {
  if (!program.options.colorSum)
    return "";
  const bool rounds = numerics == Numerics::Fp24;
  return forEachColor(program, registers, [rounds](const std::string &color) {
    const std::string clamped = "clamp(" + color + ".rgb, 0.0, 1.0)";
    return "  " + color + ".rgb = " +
           (rounds ? "arb_round(" + clamped + " + arb_colour(gl_SecondaryColor.rgb))"
                   : clamped + " + gl_SecondaryColor.rgb") +
           ";\n";
  });
}

std::string fog(const ir::Program &program, const Registers &registers, const GlslHost &host,
                Numerics numerics) {
  const ir::FogMode mode = program.options.fog;
  if (mode == ir::FogMode::None)
    return "";
  const bool rounds = numerics == Numerics::Fp24;
  const std::string distance = fogDistance(host);
  std::string text = rounds ? fogLocals24(mode, distance) : "";
  text += "  float arb_fog = clamp(" +
          (rounds ? fogFactor24(mode) : fogFactor(mode, numerics, distance)) + ", 0.0, 1.0);\n";
  return text + forEachColor(program, registers, [rounds](const std::string &color) {
           const std::string blend =
               rounds ? "arb_round(arb_round(arb_fog * " + color + ".rgb) + " +
                            "arb_round(arb_mulz(vec3(arb_round(1.0 - arb_fog)), arb_fogcolor)))"
                      : "mix(gl_Fog.color.rgb, " + color + ".rgb, arb_fog)";
           return "  " + color + " = clamp(" + color + ", 0.0, 1.0);\n  " + color +
                  ".rgb = " + blend + ";\n";
         });
}

/// Returns the position of ARB_position_invariant, computed exactly as by fixed function.
std::string invariantPosition(const ir::Program &program) {
  return program.options.positionInvariant ? "  gl_Position = ftransform();\n" : "";
}

/// Returns the clip distances of enabled planes. Distances that the program does not write are 0
/// and never clip. So are those of disabled planes before an enabled one, because hosts clip by all
/// elements up to the last written one.
std::string clipDistances(const ir::Program &program, const GlslHost &host) {
  std::string text;
  for (unsigned plane = 0; host.clipDistances >> plane != 0; ++plane) {
    const ir::Output output = {ir::OutputKind::ClipDistance, std::uint8_t(plane)};
    const bool written =
        (host.clipDistances >> plane & 1) != 0 &&
        std::find(program.outputs.begin(), program.outputs.end(), output) != program.outputs.end();
    text += "  gl_ClipDistance[" + std::to_string(plane) +
            "] = " + (written ? outputText(program, output).name : std::string("0.0")) + ";\n";
  }
  return text;
}

/// Returns the code for user clip planes (2.11). A position-invariant program is clipped in eye
/// space, as fixed function is. For other programs the specification has no clipping. Hosts clip
/// them in clip space with planes transformed by the projection, and applications rely on it.
std::string clipVertex(const ir::Program &program, const GlslHost &host) {
  if (program.language != ir::Language::ArbVertex || !host.clipPlanes)
    return "";
  if (program.options.clipsByDistances())
    return clipDistances(program, host);
  return program.options.positionInvariant
             ? "  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;\n"
             : "  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;\n";
}

class Body {
public:
  Body(const ir::Program &program, const Registers &registers, Numerics numerics)
      : m_program(program), m_registers(registers), m_numerics(numerics),
        m_ranges(program, numerics) {}

  std::string text() {
    std::string result;
    if (ir::hasLoops(m_program))
      result = "  int arb_left = " + std::to_string(ir::kMaxIterations) + ";\n";
    for (const Instruction &instruction : m_program.code) {
      if (ir::info(instruction.op).has(ir::Flow)) {
        result += flow(instruction);
        m_ranges.forget();
        continue;
      }
      result += statement(instruction);
      m_ranges.step(instruction);
    }
    return result;
  }

private:
  std::string flow(const Instruction &instruction) {
    if (instruction.op == Opcode::Endrep)
      return "  }\n";
    const std::string operand = component(m_registers, instruction.src[0], 0);
    if (instruction.op == Opcode::Brk)
      return "  if (" + operand + " != 0.0) break;\n";
    const std::string name = std::to_string(m_loops++);
    return "  int arb_n" + name + " = arb_times(" + operand + ");\n  for (int arb_i" + name +
           " = 0; arb_i" + name + " < arb_n" + name + " && arb_left > 0; ++arb_i" + name +
           ") {\n  --arb_left;\n";
  }

  std::string statement(const Instruction &instruction) const {
    if (instruction.op == Opcode::Kil)
      return "  if (" + killCondition(m_registers, instruction.src[0]) + ") discard;\n";
    if (instruction.dst.file == ir::File::Address)
      return "  a" + std::to_string(instruction.dst.index) + " = " +
             expression(m_registers, instruction, {0}, {}, m_numerics) + ";\n";
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
    std::string value = instruction.src[0].relative
                            ? Arrays::element(instruction.src[0]) + suffix(components)
                            : expression(m_registers, instruction, components,
                                         m_ranges.facts(instruction), m_numerics);
    if (instruction.dst.saturate)
      value = "clamp(" + value + ", 0.0, 1.0)";
    return "  " + target.name + (target.scalar ? "" : suffix(components)) + " = " + value + ";\n";
  }

  const ir::Program &m_program;
  const Registers &m_registers;
  Numerics m_numerics;
  RangeAnalysis m_ranges;
  int m_loops = 0;
};
} // namespace

GlslShader emit(const ir::Program &given, const GlslHost &host, Numerics numerics) {
  ir::Program program = given;
  hoistRelative(program);
  const Registers registers(program, numerics, host);
  GlslShader shader;
  const std::string code = registers.locals() + invariantPosition(program) +
                           Body(program, registers, numerics).text() +
                           colorSum(program, registers, numerics) +
                           fog(program, registers, host, numerics) + clipVertex(program, host);
  shader.text = preamble(program, registers, host, numerics) + registers.declarations() +
                helpers(program, numerics, code) + "void main() {\n" + code + "}\n";
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
