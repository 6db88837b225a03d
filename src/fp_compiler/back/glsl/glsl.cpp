#include "fp_compiler/back/glsl/glsl.h"

#include <algorithm>
#include <cassert>

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
  assert(given.options.fog == ir::FogMode::None && !given.options.colorSum);
  ir::Program program = given;
  hoistRelative(program);
  const Registers registers(program, numerics, host);
  GlslShader shader;
  const std::string code = registers.locals() + invariantPosition(program) +
                           Body(program, registers, numerics).text() + clipVertex(program, host);
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
