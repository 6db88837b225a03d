#include "apps/tools/debug/pixel/vertices.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "apps/tools/debug/pixel/cut.h"
#include "fp_compiler/back/assembly/assembly.h"

namespace arbiter::tools::debug {

namespace {

Vec4 vec4Of(const glm::vec4 &value) { return {value.x, value.y, value.z, value.w}; }

/// Returns the mesh's texture coordinates for a set.
Vec4 setOf(const scene::Panel &panel, const scene::MeshVertex &vertex, unsigned set) {
  for (const scene::CoordinateSpec &spec : panel.coordinates)
    if (spec.set == set)
      return vec4Of(scene::coordinateOf(vertex, spec));
  return {vertex.st.x, vertex.st.y, 0, 1};
}

/// Returns a generic attribute: the panel's value, or else the conventional attribute in its slot
/// (ARB_vertex_program, table X.1).
Vec4 genericOf(const VertexStage &stage, const scene::MeshVertex &vertex, unsigned index) {
  for (const scene::ParameterRow &row :
       stage.document.rows(stage.pass, stage.pass.panel, stage.seconds))
    if (row.space == scene::Setting::Attrib && row.index == index)
      return row.value;
  if (index == 0)
    return vec4Of(glm::vec4(vertex.position, 1));
  if (index == 2)
    return vec4Of(glm::vec4(vertex.normal, 1));
  if (index == 3)
    return {vertex.st.x, vertex.st.y, 0, 1};
  return index >= 8 ? setOf(stage.document.panelOf(stage.pass), vertex, index - 8)
                    : Vec4{0, 0, 0, 1};
}

Vec4 attributeOf(const VertexStage &stage, const scene::MeshVertex &vertex,
                 const fp::ir::Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::Position:
    return vec4Of(glm::vec4(vertex.position, 1));
  case AttributeKind::Normal:
    return vec4Of(glm::vec4(vertex.normal, 1));
  case AttributeKind::ColorPrimary:
    return {vertex.st.x, vertex.st.y, 0, 1};
  case AttributeKind::TexCoord:
    return setOf(stage.document.panelOf(stage.pass), vertex, attribute.index);
  case AttributeKind::Generic:
    return genericOf(stage, vertex, attribute.index);
  case AttributeKind::ColorSecondary:
  case AttributeKind::FogCoord:
  case AttributeKind::Facing:
    break;
  }
  return {0, 0, 0, 1};
}

bool isOfVertexProgramsAlone(const fp::ir::StateRef &state) {
  return state.item >= StateItem::TexGenEye;
}

/// Reads all parameters that the program uses.
class Parameters {
public:
  Parameters(const VertexStage &stage, Drawer &drawer) : m_stage(stage), m_drawer(drawer) {}

  Result<std::vector<Vec4>, DebugError> read(int x, int y) {
    m_values.resize(m_stage.program.parameters.size());
    const auto rows = m_stage.document.rows(m_stage.pass, m_stage.pass.vertex, m_stage.seconds);
    std::vector<std::size_t> states;
    for (std::size_t i = 0; i < m_values.size(); ++i) {
      const fp::ir::Parameter &parameter = m_stage.program.parameters[i];
      if (parameter.kind == fp::ir::ParameterKind::State) {
        if (!isOfVertexProgramsAlone(parameter.state)) {
          states.push_back(i);
        } else {
          const auto value = m_drawer.vertexState(parameter.state);
          if (!value)
            return value.error();
          m_values[i] = value.value();
        }
      }
      for (const scene::ParameterRow &row : rows)
        if (isRow(parameter, row))
          m_values[i] = row.value;
    }
    for (std::size_t from = 0; from < states.size(); from += kMaxTargets)
      if (auto error = draw(states, from, x, y))
        return *error;
    return m_values;
  }

private:
  static bool isRow(const fp::ir::Parameter &parameter, const scene::ParameterRow &row) {
    return row.index == parameter.index &&
           ((parameter.kind == fp::ir::ParameterKind::Local &&
             row.space == scene::Setting::Local) ||
            (parameter.kind == fp::ir::ParameterKind::Env && row.space == scene::Setting::Env));
  }

  /// Draws rows of GL's state with a fragment program, because both stages share the state.
  std::optional<DebugError> draw(const std::vector<std::size_t> &states, std::size_t from, int x,
                                 int y) {
    fp::ir::Program tables;
    std::vector<fp::ir::Operand> operands;
    const std::size_t count = std::min(kMaxTargets, states.size() - from);
    for (std::size_t i = 0; i < count; ++i) {
      tables.parameters.push_back(m_stage.program.parameters[states[from + i]]);
      operands.emplace_back().file = fp::ir::File::Parameter;
      operands.back().index = std::uint16_t(i);
    }
    const auto drawn =
        m_drawer.draw(fp::emitAssembly(showOperands(tables, operands)), count, {x, y, 1, 1});
    if (!drawn)
      return drawn.error();
    for (std::size_t i = 0; i < count; ++i)
      m_values[states[from + i]] = drawn.value()[i];
    return {};
  }

  const VertexStage &m_stage;
  Drawer &m_drawer;
  std::vector<Vec4> m_values;
};

struct Corner {
  float x = 0, y = 0, z = 0; ///< in window pixels, z in [-1,1]
  bool isBehind = false;
};

Corner cornerOf(const Vec4 &clip, const std::array<int, 2> &size) {
  Corner corner;
  corner.isBehind = !(clip[3] > 0);
  corner.x = (clip[0] / clip[3] * 0.5f + 0.5f) * float(size[0]);
  corner.y = (clip[1] / clip[3] * 0.5f + 0.5f) * float(size[1]);
  corner.z = clip[2] / clip[3];
  return corner;
}

float area(const Corner &a, const Corner &b, float x, float y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// Returns a triangle's depth at a position; nothing if the triangle is culled or does not cover
/// it.
std::optional<float> depthAt(const std::array<Corner, 3> &t, float x, float y, scene::Cull cull) {
  if (t[0].isBehind || t[1].isBehind || t[2].isBehind)
    return {};
  const float whole = area(t[0], t[1], t[2].x, t[2].y);
  if (whole == 0 || (cull == scene::Cull::Back && whole < 0) ||
      (cull == scene::Cull::Front && whole > 0))
    return {};
  const float a = area(t[1], t[2], x, y) / whole, b = area(t[2], t[0], x, y) / whole;
  const float c = area(t[0], t[1], x, y) / whole;
  if (a < 0 || b < 0 || c < 0)
    return {};
  return a * t[0].z + b * t[1].z + c * t[2].z;
}

class Tracer {
public:
  Tracer(const VertexStage &stage, std::vector<Vec4> parameters) : m_stage(stage) {
    m_inputs.parameters = std::move(parameters);
  }

  Result<TracedTriangle, DebugError> run(const scene::Mesh &mesh, const std::array<int, 2> &size,
                                         int x, int y) {
    std::vector<Vec4> clips;
    clips.reserve(mesh.vertices.size());
    for (const scene::MeshVertex &vertex : mesh.vertices)
      clips.push_back(positionOf(vertex));
    const auto found = find(mesh, clips, size, float(x) + 0.5f, float(y) + 0.5f);
    if (!found)
      return DebugError{"no triangle of the mesh covers this pixel's centre"};
    TracedTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i].index = mesh.indices[*found + i];
      triangle[i].clip = clips[triangle[i].index];
      m_inputs.attributes = attributesOf(m_stage, mesh.vertices[triangle[i].index]);
      triangle[i].trace = record(m_stage.program, m_stage.text, m_inputs,
                                 {fp::Numerics::Host, fp::Numerics::Legacy});
    }
    return triangle;
  }

private:
  Vec4 positionOf(const scene::MeshVertex &vertex) {
    if (m_stage.program.options.positionInvariant) {
      const scene::View view = m_stage.document.viewOf(m_stage.pass);
      return vec4Of(view.projection * (view.modelView * glm::vec4(vertex.position, 1)));
    }
    m_inputs.attributes = attributesOf(m_stage, vertex);
    const fp::ir::Evaluation end = fp::ir::evaluate(
        m_stage.program, interpreterInputs(m_stage.program, m_inputs, fp::Numerics::Host));
    for (std::size_t o = 0; o < m_stage.program.outputs.size(); ++o)
      if (m_stage.program.outputs[o].kind == fp::ir::OutputKind::Position)
        return end.outputs[o];
    return {};
  }

  /// Returns the position of the visible triangle's first index.
  std::optional<std::size_t> find(const scene::Mesh &mesh, const std::vector<Vec4> &clips,
                                  const std::array<int, 2> &size, float x, float y) const {
    const auto &cull = m_stage.document.panelOf(m_stage.pass).state.cull;
    const bool nearest = m_stage.document.depthOf(m_stage.pass) != scene::Depth::Off;
    std::optional<std::size_t> found;
    float best = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = cornerOf(clips[mesh.indices[i + k]], size);
      const auto depth = depthAt(corners, x, y, cull ? cull->value : scene::Cull::None);
      if (!depth || (found && nearest && *depth >= best))
        continue;
      found = i;
      best = *depth;
    }
    return found;
  }

  const VertexStage &m_stage;
  TraceInputs m_inputs;
};

} // namespace

std::vector<Vec4> attributesOf(const VertexStage &stage, const scene::MeshVertex &vertex) {
  std::vector<Vec4> values;
  for (const fp::ir::Attribute &attribute : stage.program.attributes)
    values.push_back(attributeOf(stage, vertex, attribute));
  return values;
}

Result<TracedTriangle, DebugError> traceTriangle(const VertexStage &stage, Drawer &drawer, int x,
                                                 int y) {
  const auto mesh = scene::buildMesh(stage.document.meshOf(stage.pass), stage.document.folder);
  if (!mesh)
    return DebugError{mesh.error().message};
  auto parameters = Parameters(stage, drawer).read(x, y);
  if (!parameters)
    return parameters.error();
  return Tracer(stage, std::move(parameters).value()).run(mesh.value(), drawer.size(), x, y);
}

} // namespace arbiter::tools::debug
