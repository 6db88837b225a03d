#include "program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "fp_compiler/ati/limits.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

namespace gallery {

namespace {

using namespace arbiter;
using ir::AttributeKind;
using ir::OutputKind;
using scene::Setting;

ir::Vec4 plain(const glm::vec4 &value) { return {value.x, value.y, value.z, value.w}; }
glm::vec4 vector(const ir::Vec4 &value) { return glm::make_vec4(value.data()); }

ir::Program compiled(const scene::ProgramFile &file) {
  const fp::hw::Profile &widest = *fp::hw::findBuiltin("host");
  const auto limits = file.language == ir::Language::ArbVertex ? widest.vertex
                      : file.language == ir::Language::AtiFragment
                          ? fp::ati::limitsOf(widest.fragment)
                          : widest.fragment;
  auto result = fp::checkProgram(file.language, file.text, {limits, fp::LimitPolicy::Report});
  if (!result.ok()) {
    std::fputs(fp::renderAll(file.name, file.text, result.diagnostics).c_str(), stderr);
    std::exit(1);
  }
  return std::move(*result.program);
}

} // namespace

Program::Program(const scene::Document &document, const scene::Pass &pass, int file, double seconds)
    : m_program(compiled(document.files[std::size_t(file)])),
      m_rows(document.rows(pass, file, seconds)), m_view(document.viewOf(pass)) {}

ir::Vec4 Program::parameter(const ir::Parameter &parameter) const {
  if (parameter.kind == ir::ParameterKind::State)
    return stateRow(parameter.state);
  const Setting space = parameter.kind == ir::ParameterKind::Local ? Setting::Local : Setting::Env;
  for (const scene::ParameterRow &row : m_rows)
    if (row.space == space && row.index == parameter.index)
      return row.value;
  return {};
}

ir::Vec4 Program::stateRow(const ir::StateRef &state) const {
  glm::mat4 matrix(1.0f);
  if (state.item == ir::StateItem::MatrixModelview)
    matrix = m_view.modelView;
  else if (state.item == ir::StateItem::MatrixProjection)
    matrix = m_view.projection;
  else if (state.item == ir::StateItem::MatrixMvp)
    matrix = m_view.projection * m_view.modelView;
  const auto modifier = state.modifier;
  if (modifier == ir::MatrixModifier::Inverse || modifier == ir::MatrixModifier::InvTrans)
    matrix = glm::inverse(matrix);
  if (modifier == ir::MatrixModifier::Transpose || modifier == ir::MatrixModifier::InvTrans)
    matrix = glm::transpose(matrix);
  return plain(glm::transpose(matrix)[state.row]);
}

VertexStage::VertexStage(const scene::Document &document, const scene::Pass &pass, double seconds)
    : m_panel(document.panelOf(pass)) {
  if (pass.vertex >= 0)
    m_program.emplace(document, pass, pass.vertex, seconds);
  const scene::View view = document.viewOf(pass);
  m_toClip = view.projection * view.modelView;
}

glm::vec4 VertexStage::coordinate(const scene::MeshVertex &vertex, unsigned set) const {
  for (const scene::CoordinateSpec &spec : m_panel.coordinates)
    if (spec.set == set)
      return scene::coordinateOf(vertex, spec);
  return {vertex.st, 0.0f, 1.0f};
}

ir::Vec4 VertexStage::attribute(const scene::MeshVertex &vertex,
                                const ir::Attribute &attribute) const {
  switch (attribute.kind) {
  case AttributeKind::Position:
    return plain({vertex.position, 1.0f});
  case AttributeKind::Normal:
    return plain({vertex.normal, 1.0f});
  case AttributeKind::ColorPrimary:
    return plain({vertex.st, 0.0f, 1.0f});
  case AttributeKind::TexCoord:
    return plain(coordinate(vertex, attribute.index));
  default:
    return {};
  }
}

Vertex VertexStage::run(const scene::MeshVertex &vertex) const {
  Vertex result;
  if (!m_program) {
    result.clip = m_toClip * glm::vec4(vertex.position, 1.0f);
    for (unsigned set = 0; set < 8; ++set)
      result.varyings[set] = coordinate(vertex, set);
    result.varyings[kColor] = {vertex.st, 0.0f, 1.0f};
    return result;
  }
  const ir::Program &code = m_program->code();
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &each : code.attributes)
    attributes.push_back(attribute(vertex, each));
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [&](const ir::Parameter &parameter) {
    return m_program->parameter(parameter);
  };
  const ir::Evaluation evaluation = ir::evaluate(code, inputs);
  for (std::size_t i = 0; i < code.outputs.size(); ++i) {
    const glm::vec4 value = vector(evaluation.outputs[i]);
    if (code.outputs[i].kind == OutputKind::Position)
      result.clip = value;
    else if (code.outputs[i].kind == OutputKind::TexCoord)
      result.varyings[code.outputs[i].index] = value;
    else if (code.outputs[i].kind == OutputKind::FrontPrimary)
      result.varyings[kColor] = value;
  }
  return result;
}

FragmentStage::FragmentStage(const scene::Document &document, const scene::Pass &pass,
                             double seconds)
    : m_program(document, pass, pass.fragment, seconds), m_textures(scene::kMaxUnits) {}

void FragmentStage::setTexture(unsigned unit, Texture texture) {
  m_textures[unit] = std::move(texture);
}

std::array<bool, kVaryings> FragmentStage::used() const {
  std::array<bool, kVaryings> used = {};
  for (const ir::Attribute &attribute : m_program.code().attributes)
    if (attribute.kind == AttributeKind::TexCoord)
      used[attribute.index] = true;
    else if (attribute.kind == AttributeKind::ColorPrimary)
      used[kColor] = true;
  return used;
}

bool FragmentStage::kills() const {
  const auto &code = m_program.code().code;
  return std::any_of(code.begin(), code.end(), [](const ir::Instruction &instruction) {
    return ir::info(instruction.op).has(ir::Kills);
  });
}

ir::Vec4 FragmentStage::attribute(const Fragment &fragment, const ir::Attribute &attribute) const {
  switch (attribute.kind) {
  case AttributeKind::TexCoord:
    return plain(fragment.varyings[attribute.index]);
  case AttributeKind::ColorPrimary:
    return plain(fragment.varyings[kColor]);
  case AttributeKind::Position:
    return {float(fragment.x) + 0.5f, float(fragment.y) + 0.5f, float(fragment.depth),
            float(fragment.inverseW)};
  default:
    return {};
  }
}

std::optional<glm::vec4> FragmentStage::run(const Fragment &fragment) const {
  const ir::Program &code = m_program.code();
  std::vector<ir::Vec4> attributes;
  for (const ir::Attribute &each : code.attributes)
    attributes.push_back(attribute(fragment, each));
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [&](const ir::Parameter &parameter) { return m_program.parameter(parameter); };
  inputs.texture = [&](const ir::Sample &at) {
    const auto &texture = m_textures[at.unit];
    return texture ? sample(*texture, at) : ir::Vec4{0, 0, 0, 1};
  };
  const ir::Evaluation evaluation = ir::evaluate(code, inputs);
  if (evaluation.killed)
    return std::nullopt;
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    if (code.outputs[i].kind == OutputKind::Color)
      return vector(evaluation.outputs[i]);
  return glm::vec4(0.0f);
}

} // namespace gallery
