#include "fp_compiler/back/glsl/registers.h"

#include <algorithm>
#include <cassert>

#include "fp_compiler/back/glsl/number.h"
#include "fp_compiler/back/glsl/state.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::glsl {

using ir::File;

namespace {
bool named(const RegisterText &text) { return !text.components[0].empty(); }

bool sameRow(const ir::Parameter &a, const ir::Parameter &b) {
  if (a.kind != b.kind)
    return false;
  return a.kind == ir::ParameterKind::State ? a.state == b.state : a.index == b.index;
}

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

} // namespace

Registers::Registers(const ir::Program &program, Numerics numerics, const GlslHost &host)
    : m_numerics(numerics), m_alphaDepths(host.alphaDepths), m_spriteUnits(host.spriteUnits),
      m_negativeFogDistances(host.negativeFogDistances), m_spriteS(host.spriteS),
      m_ofVertices(program.language == ir::Language::ArbVertex),
      m_uniformArray(program.language == ir::Language::ArbVertex ? "arb_vparam" : "arb_param"),
      m_arrays(program, m_uniformArray, m_uniforms), m_temporaries(program.temporaries.size()),
      m_attributes(program.attributes.size()), m_parameters(program.parameters.size()),
      m_locals(m_arrays.locals()) {
  for (const ir::Instruction &instruction : program.code) {
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (ir::registerMask(instruction, i) != 0)
        nameUsed(program, instruction.src[std::size_t(i)]);
    if (ir::info(instruction.op).has(ir::Texture))
      nameSampler(instruction);
  }
  nameTemporaries(program);
  nameAddresses(program);
  nameOutputs(program);
}

std::string Registers::declarations() const {
  std::string text;
  if (!m_uniforms.empty())
    text += "uniform vec4 " + m_uniformArray + "[" + std::to_string(m_uniforms.size()) + "];\n";
  for (const GlslAttribute &attribute : m_generics)
    text += "attribute vec4 " + attribute.name + ";\n";
  for (const GlslSampler &sampler : m_samplers)
    text += std::string("uniform ") + samplerType(sampler.target) + " " + sampler.uniform + ";\n";
  return text + m_arrays.functions();
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

void Registers::nameUsed(const ir::Program &program, const ir::Operand &operand) {
  if (operand.relative)
    return;
  if (operand.file == File::Attribute && !named(m_attributes[operand.index]))
    nameAttribute(program, operand.index);
  else if (operand.file == File::Parameter && !named(m_parameters[operand.index]))
    nameParameter(operand.index, program.parameters[operand.index]);
}

void Registers::nameAttribute(const ir::Program &program, std::size_t index) {
  const ir::Attribute &attribute = program.attributes[index];
  m_attributes[index] = attributeText(program.language, attribute);
  if (!m_ofVertices && attribute.kind == ir::AttributeKind::TexCoord && attribute.index < 8 &&
      (m_spriteUnits >> attribute.index & 1u) != 0)
    m_attributes[index] = spriteText(attribute.index);
  // In these languages only fog reads the coordinate. ARB programs get the host's own value.
  if (m_negativeFogDistances && ir::isNvparse(program.language) &&
      attribute.kind == ir::AttributeKind::FogCoord)
    m_attributes[index].components[0] = "abs(" + m_attributes[index].components[0] + ")";
  m_readsPosition |= attribute.kind == ir::AttributeKind::Position;
  if (attribute.kind == ir::AttributeKind::Generic && attribute.index != 0)
    m_generics.push_back({genericName(attribute.index), attribute.index});
  const bool color = attribute.kind == ir::AttributeKind::ColorPrimary ||
                     attribute.kind == ir::AttributeKind::ColorSecondary;
  makeLocal(m_attributes[index], "i" + std::to_string(index), color ? "arb_colour" : "arb_round");
}

/// Returns the coordinates of a point sprite (NV_point_sprite, 3.3), with a mode other than ZERO.
RegisterText Registers::spriteText(int index) {
  const std::string number = std::to_string(index), local = "arb_sprite" + number,
                    vertex = "gl_TexCoord[" + number + "]";
  m_locals += "  vec4 " + local + " = vec4(gl_PointCoord, " + vertex + (m_spriteS ? ".s" : ".p") +
              " / " + vertex + ".q, 1.0);\n";
  return variable(local);
}

/// Under Fp24, copies a register to a local that holds its value passed through \p function.
void Registers::makeLocal(RegisterText &name, const std::string &local, const char *function) {
  if (m_numerics != Numerics::Fp24)
    return;
  const auto &parts = name.components;
  const std::string whole = name.variable.empty() ? "vec4(" + parts[0] + ", " + parts[1] + ", " +
                                                        parts[2] + ", " + parts[3] + ")"
                                                  : name.variable;
  m_locals += "  vec4 " + local + " = " + function + "(" + whole + ");\n";
  name = variable(local);
}

void Registers::nameParameter(std::size_t index, const ir::Parameter &parameter) {
  RegisterText &name = m_parameters[index];
  if (parameter.kind == ir::ParameterKind::Constant) {
    for (std::size_t i = 0; i < 4; ++i)
      name.components[i] =
          number(m_numerics == Numerics::Fp24 ? fp24::truncated(parameter.constant[i])
                                              : parameter.constant[i]);
    return;
  }
  const std::string local = "s" + std::to_string(index);
  const auto state = parameter.kind == ir::ParameterKind::State ? stateText(parameter.state)
                                                                : std::optional<StateText>();
  if (!state) {
    nameUniform(name, parameter);
  } else if (state->isVariable || m_numerics == Numerics::Fp24) {
    name = variable(state->text);
  } else {
    m_locals += "  vec4 " + local + " = " + state->text + ";\n";
    name = variable(local);
  }
  makeLocal(name, local, "arb_truncate");
}

void Registers::nameUniform(RegisterText &name, const ir::Parameter &parameter) {
  const auto found = std::find_if(m_uniforms.begin(), m_uniforms.end(), [&](const GlslUniform &u) {
    return sameRow(u.parameter, parameter);
  });
  const auto element = found - m_uniforms.begin();
  if (found == m_uniforms.end())
    m_uniforms.push_back({parameter});
  name = variable(m_uniformArray + "[" + std::to_string(element) + "]");
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
  const std::vector<bool> needsZero = ir::readsUnwritten(program);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i])
      continue;
    const std::string name = "t" + std::to_string(i);
    m_temporaries[i] = variable(name);
    m_locals += "  vec4 " + name + (needsZero[i] ? " = vec4(0.0);\n" : ";\n");
  }
}

void Registers::nameAddresses(const ir::Program &program) {
  std::vector<bool> used(program.addresses.size(), false);
  for (const ir::Instruction &instruction : program.code) {
    if (instruction.dst.file == File::Address)
      used[instruction.dst.index] = true;
    for (int i = 0; i < ir::info(instruction.op).operandCount(); ++i)
      if (instruction.src[std::size_t(i)].relative)
        used[instruction.src[std::size_t(i)].address] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i])
      m_locals += "  int a" + std::to_string(i) + " = 0;\n";
}

/// A position that is clipped whatever x, y and z the program writes.
constexpr const char *kNowhere = "vec4(0.0, 0.0, 0.0, -1.0)";

/// Names the outputs. A partly written output starts at zero. One that is bound but never written
/// is left out.
void Registers::nameOutputs(const ir::Program &program) {
  std::vector<std::uint8_t> written(program.outputs.size(), 0);
  for (const ir::Instruction &instruction : program.code)
    if (ir::writeMask(instruction) && instruction.dst.file == File::Output)
      written[instruction.dst.index] |= ir::writeMask(instruction);
  bool main = false; // the output that hosts need to link: position, or a colour
  const bool vertex = program.language == ir::Language::ArbVertex;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const ir::Output &output = program.outputs[i];
    m_outputs.push_back(outputText(program, output));
    const OutputText &text = m_outputs.back();
    const std::uint8_t wanted = ir::resultMask(output.kind);
    const bool missing = (wanted & ~written[i]) != 0;
    if (output.kind == ir::OutputKind::Depth) {
      if (missing) // the fragment keeps its own depth
        m_locals += "  gl_FragDepth = gl_FragCoord.z;\n";
      continue;
    }
    if (output.kind == ir::OutputKind::ClipDistance) {
      m_locals += "  float " + text.name + " = 0.0;\n";
      continue;
    }
    if (vertex && (wanted & written[i]) == 0)
      continue;
    main |= !vertex || output.kind == ir::OutputKind::Position;
    // Without w, a position is outside of every volume. Hosts treat a w of zero differently.
    const bool noPlace = output.kind == ir::OutputKind::Position && (written[i] & 8) == 0;
    if (missing)
      m_locals += "  " + text.name +
                  (text.scalar ? " = 0.0;\n"
                   : noPlace   ? " = " + std::string(kNowhere) + ";\n"
                               : " = vec4(0.0);\n");
  }
  // The specification leaves these outputs undefined. Colours become zero, and without a position
  // nothing is drawn.
  if (main || (vertex && program.options.positionInvariant))
    return;
  if (vertex) {
    m_locals += std::string("  gl_Position = ") + kNowhere + ";\n";
    return;
  }
  const char *name = program.options.drawBuffers ? "gl_FragData[0]" : "gl_FragColor";
  m_locals += std::string("  ") + name + " = vec4(0.0);\n";
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
