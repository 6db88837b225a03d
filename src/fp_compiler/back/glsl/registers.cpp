#include "fp_compiler/back/glsl/registers.h"

#include <algorithm>
#include <cassert>

#include "fp_compiler/back/glsl/number.h"
#include "fp_compiler/back/glsl/state.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::File;

namespace {
RegisterText variable(const std::string &name) {
  return {name, {name + ".x", name + ".y", name + ".z", name + ".w"}};
}

bool named(const RegisterText &text) { return !text.components[0].empty(); }

bool sameRow(const ir::Parameter &a, const ir::Parameter &b) {
  if (a.kind != b.kind)
    return false;
  return a.kind == ir::ParameterKind::State ? a.state == b.state : a.index == b.index;
}

/// Components of each register that some instruction reads before any instruction wrote them:
/// those must be zero.
std::vector<bool> readsUnwritten(const ir::Program &program) {
  std::vector<std::uint8_t> written(program.temporaries.size(), 0);
  std::vector<bool> result(program.temporaries.size(), false);
  for (const ir::Instruction &instruction : program.code) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i) {
      const ir::Operand &operand = instruction.src[std::size_t(i)];
      if (operand.file == File::Temporary &&
          (ir::registerMask(instruction, i) & ~written[operand.index]))
        result[operand.index] = true;
    }
    if (ir::writeMask(instruction) && instruction.dst.file == File::Temporary)
      written[instruction.dst.index] |= ir::writeMask(instruction);
  }
  return result;
}
} // namespace

Registers::Registers(const ir::Program &program)
    : m_temporaries(program.temporaries.size()), m_attributes(program.attributes.size()),
      m_parameters(program.parameters.size()), m_outputs(program.outputs.size()) {
  for (const ir::Instruction &instruction : program.code) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (ir::registerMask(instruction, i) != 0)
        nameUsed(program, instruction.src[std::size_t(i)]);
    if (ir::info(instruction.op).has(ir::Texture))
      nameSampler(instruction);
  }
  nameTemporaries(program);
  nameOutputs(program);
}

const RegisterText &Registers::source(File file, std::uint16_t index) const {
  switch (file) {
  case File::Temporary:
    return m_temporaries[index];
  case File::Attribute:
    return m_attributes[index];
  case File::Parameter:
  case File::Output:
  case File::Address:
    break;
  }
  assert(file == File::Parameter);
  return m_parameters[index];
}

const std::string &Registers::temporary(std::uint16_t index) const {
  return m_temporaries[index].variable;
}

const std::string &Registers::output(std::uint16_t index) const { return m_outputs[index]; }

void Registers::nameUsed(const ir::Program &program, const ir::Operand &operand) {
  if (operand.file == File::Attribute && !named(m_attributes[operand.index]))
    nameAttribute(operand.index, program.attributes[operand.index]);
  else if (operand.file == File::Parameter && !named(m_parameters[operand.index]))
    nameParameter(operand.index, program.parameters[operand.index]);
}

void Registers::nameAttribute(std::size_t index, const ir::Attribute &attribute) {
  RegisterText &name = m_attributes[index];
  switch (attribute.kind) {
  case ir::AttributeKind::ColorPrimary:
    name = variable("gl_Color");
    break;
  case ir::AttributeKind::ColorSecondary:
    name = variable("gl_SecondaryColor");
    break;
  case ir::AttributeKind::TexCoord:
    name = variable("gl_TexCoord[" + std::to_string(attribute.index) + "]");
    break;
  case ir::AttributeKind::FogCoord:
    name = {"", {"gl_FogFragCoord", "0.0", "0.0", "1.0"}};
    break;
  case ir::AttributeKind::Position:
    name = variable("gl_FragCoord");
    m_readsPosition = true;
    break;
  case ir::AttributeKind::Normal:
  case ir::AttributeKind::Generic:
    break; // vertex programs
  }
}

void Registers::nameParameter(std::size_t index, const ir::Parameter &parameter) {
  RegisterText &name = m_parameters[index];
  if (parameter.kind == ir::ParameterKind::Constant) {
    for (std::size_t i = 0; i < 4; ++i)
      name.components[i] = number(parameter.constant[i]);
    return;
  }
  if (parameter.kind == ir::ParameterKind::State) {
    if (const auto state = stateText(parameter.state)) {
      if (state->isVariable) {
        name = variable(state->text);
        return;
      }
      const std::string local = "s" + std::to_string(index);
      m_locals += "  vec4 " + local + " = " + state->text + ";\n";
      name = variable(local);
      return;
    }
  }
  nameUniform(name, parameter);
}

void Registers::nameUniform(RegisterText &name, const ir::Parameter &parameter) {
  const auto found = std::find_if(m_uniforms.begin(), m_uniforms.end(), [&](const GlslUniform &u) {
    return sameRow(u.parameter, parameter);
  });
  const auto element = found - m_uniforms.begin();
  if (found == m_uniforms.end())
    m_uniforms.push_back({parameter});
  name = variable("arb_param[" + std::to_string(element) + "]");
}

void Registers::nameTemporaries(const ir::Program &program) {
  std::vector<bool> used(program.temporaries.size(), false);
  for (const ir::Instruction &instruction : program.code) {
    if (ir::writeMask(instruction) && instruction.dst.file == File::Temporary)
      used[instruction.dst.index] = true;
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (instruction.src[std::size_t(i)].file == File::Temporary &&
          ir::registerMask(instruction, i) != 0)
        used[instruction.src[std::size_t(i)].index] = true;
  }
  const std::vector<bool> needsZero = readsUnwritten(program);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i])
      continue;
    const std::string name = "t" + std::to_string(i);
    m_temporaries[i] = variable(name);
    m_locals += "  vec4 " + name + (needsZero[i] ? " = vec4(0.0);\n" : ";\n");
  }
}

void Registers::nameOutputs(const ir::Program &program) {
  std::vector<std::uint8_t> written(program.outputs.size(), 0);
  for (const ir::Instruction &instruction : program.code)
    if (ir::writeMask(instruction) && instruction.dst.file == File::Output)
      written[instruction.dst.index] |= ir::writeMask(instruction);
  bool color = false;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    if (program.outputs[i].kind == ir::OutputKind::Depth) {
      // Only z counts (table X.3); without it the fragment keeps its own depth.
      if ((written[i] & 4) == 0)
        m_locals += "  gl_FragDepth = gl_FragCoord.z;\n";
      continue;
    }
    color = true;
    m_outputs[i] = program.options.drawBuffers
                       ? "gl_FragData[" + std::to_string(program.outputs[i].index) + "]"
                       : "gl_FragColor";
    if (written[i] != 0xF)
      m_locals += "  " + m_outputs[i] + " = vec4(0.0);\n";
  }
  // A program without a colour leaves it undefined (3.11.3.4): zero, as everything undefined.
  if (!color)
    m_locals += program.options.drawBuffers ? "  gl_FragData[0] = vec4(0.0);\n"
                                            : "  gl_FragColor = vec4(0.0);\n";
}

void Registers::nameSampler(const ir::Instruction &instruction) {
  for (const GlslSampler &sampler : m_samplers)
    if (sampler.unit == instruction.unit) {
      assert(sampler.target == instruction.target && "one target a unit (3.11.6)");
      return;
    }
  m_samplers.push_back(
      {"arb_tex" + std::to_string(instruction.unit), instruction.unit, instruction.target});
  if (instruction.target == ir::TexTarget::Rect || instruction.target == ir::TexTarget::ShadowRect)
    m_readsRectangle = true;
}

} // namespace arbiter::fp::glsl
