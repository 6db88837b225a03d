#include "state/raster_draw/fixed_function/fixed_vertex.h"

#include <algorithm>
#include <cfloat>

#include "state/raster_draw/fixed_function/fixed_writer.h"

namespace arbiter::state {

using fp::ir::Opcode;
using fp::ir::OutputKind;
using fp::ir::StateItem;

FixedVertexKey fixedVertexKey(const VertexState &state, const VertexNeeds &needs) {
  FixedVertexKey key;
  key.needs = needs;
  key.clipPlanes = state.clipPlanes;
  key.textureMatrix = state.textureMatrix & needs.texCoords;
  key.fogFrom = needs.fogCoord ? state.fogFrom : FogFrom::Coordinate;
  key.pointAttenuation = needs.pointSize && state.pointAttenuation;
  key.needs.pointSize = key.pointAttenuation != 0;
  if (!state.lighting || (!needs.primary && !needs.secondary))
    key.needs.frontMaterials = key.needs.backMaterials = 0;
  else if (!state.twoSided)
    key.needs.backMaterials = 0;
  bool normals = false;
  for (std::size_t unit = 0; unit < key.texGen.size(); ++unit) {
    if ((needs.texCoords >> unit & 1u) == 0)
      continue;
    key.texGen[unit] = state.texGen[unit];
    for (const std::uint8_t mode : key.texGen[unit])
      normals |= mode > 1 + int(TexGenMode::EyeLinear);
  }
  if (needs.primary || needs.secondary)
    key.clampColors = state.clampColors;
  if (state.lighting && (needs.primary || needs.secondary)) {
    key.lighting = 1;
    key.twoSided = state.twoSided;
    key.separateSpecular = state.separateSpecular;
    key.lights = state.lights;
    key.positional = state.positional & state.lights;
    key.spots = state.spots & state.lights;
    key.attenuated = state.attenuated & state.lights;
    key.localViewer = state.localViewer && state.lights != 0;
    if (state.colorMaterial) {
      key.colorMaterialFace = state.colorMaterialFace;
      key.colorMaterialParts = state.colorMaterialParts;
    }
    normals |= state.lights != 0;
  }
  if (normals) {
    key.normalize = state.normalize;
    key.rescale = state.rescale && !state.normalize;
  }
  return key;
}

fp::ir::Source FixedWriter::constant(float x, float y, float z, float w) {
  const fp::ir::Vec4 value = {x, y, z, w};
  for (const ConstantRow &row : m_constants)
    if (row.value == value)
      return row.source;
  m_constants.push_back({value, m_builder.constant(x, y, z, w)});
  return m_constants.back().source;
}

fp::ir::Source FixedWriter::state(const fp::ir::StateRef &ref) {
  for (const StateRow &row : m_states)
    if (row.ref == ref)
      return row.source;
  m_states.push_back({ref, m_builder.state(ref)});
  return m_states.back().source;
}

fp::ir::Source FixedWriter::state(StateItem item, int index, int row, bool back) {
  fp::ir::StateRef ref;
  ref.item = item;
  ref.index = std::uint8_t(index);
  ref.row = std::uint8_t(row);
  ref.back = back;
  return state(ref);
}

fp::ir::Source FixedWriter::matrixRow(StateItem item, int index, int row, MatrixModifier modifier) {
  fp::ir::StateRef ref;
  ref.item = item;
  ref.index = std::uint8_t(index);
  ref.row = std::uint8_t(row);
  ref.modifier = modifier;
  return state(ref);
}

fp::ir::Source FixedWriter::eye() {
  if (m_eye)
    return *m_eye;
  const fp::ir::Target eye = temporary();
  for (int row = 0; row < 4; ++row)
    op(Opcode::Dp4, eye.mask(fp::ir::kLetters[row]),
       {matrixRow(StateItem::MatrixModelview, 0, row), attribute(Kind::Position)});
  return *(m_eye = eye.read());
}

/// Returns the squared length, at least the smallest normal number, so that its root has a
/// reciprocal.
fp::ir::Source FixedWriter::square(const fp::ir::Source &vector) {
  const fp::ir::Target square = temporary();
  op(Opcode::Dp3, square.mask("x"), {vector, vector});
  op(Opcode::Max, square.mask("x"), {square.read(), constant(FLT_MIN, FLT_MIN, FLT_MIN, FLT_MIN)});
  return square.read();
}

fp::ir::Source FixedWriter::normalized(const fp::ir::Source &vector) {
  const fp::ir::Target unit = temporary();
  op(Opcode::Rsq, unit.mask("w"), {square(vector).swz("x")});
  op(Opcode::Mul, unit.mask("xyz"), {vector, unit.read().swz("w")});
  return unit.read();
}

fp::ir::Source FixedWriter::eyeUnit() {
  if (!m_eyeUnit)
    m_eyeUnit = normalized(eye());
  return *m_eyeUnit;
}

/// Returns the normal, transformed by the inverse transpose of the modelview matrix (2.10.3).
fp::ir::Source FixedWriter::normal() {
  if (m_normal)
    return *m_normal;
  const fp::ir::Target normal = temporary();
  for (int row = 0; row < 3; ++row)
    op(Opcode::Dp3, normal.mask(fp::ir::kLetters[row]),
       {matrixRow(StateItem::MatrixModelview, 0, row, MatrixModifier::InvTrans),
        attribute(Kind::Normal)});
  if (m_key.normalize)
    return *(m_normal = normalized(normal.read()));
  if (m_key.rescale) {
    const fp::ir::Source third =
        matrixRow(StateItem::MatrixModelview, 0, 2, MatrixModifier::Inverse);
    const fp::ir::Target factor = temporary();
    op(Opcode::Rsq, factor.mask("x"), {square(third).swz("x")});
    op(Opcode::Mul, normal.mask("xyz"), {normal.read(), factor.read().swz("x")});
  }
  return *(m_normal = normal.read());
}

/// Writes the position, and clip distances (2.12) as addClipDistances() does.
void FixedWriter::position() {
  const fp::ir::Target result = m_builder.result(OutputKind::Position);
  const fp::ir::Target position = m_key.clipPlanes == 0 ? result : temporary();
  for (int row = 0; row < 4; ++row)
    op(Opcode::Dp4, position.mask(fp::ir::kLetters[row]),
       {matrixRow(StateItem::MatrixMvp, 0, row), attribute(Kind::Position)});
  if (m_key.clipPlanes == 0)
    return;
  op(Opcode::Mov, result, {position.read()});
  const fp::ir::Target eye = temporary();
  for (int row = 0; row < 4; ++row)
    op(Opcode::Dp4, eye.mask(fp::ir::kLetters[row]),
       {matrixRow(StateItem::MatrixProjection, 0, row, MatrixModifier::Inverse), position.read()});
  for (int plane = 0; plane < 8; ++plane)
    if ((m_key.clipPlanes >> plane & 1u) != 0)
      op(Opcode::Dp4,
         m_builder.result(OutputKind::TexCoord, kClipDistanceOutput + plane / 4)
             .mask(fp::ir::kLetters[plane % 4]),
         {state(StateItem::ClipPlane, plane), eye.read()});
}

void FixedWriter::storeColor(OutputKind kind, const fp::ir::Source &value) {
  const fp::ir::Target to = m_builder.result(kind);
  switch (m_key.clampColors) {
  case ColorClamp::None:
    return op(Opcode::Mov, to, {value});
  case ColorClamp::NanIsZero:
    return op(Opcode::Mov, to.sat(), {value});
  case ColorClamp::NanIsOne:
    return op(Opcode::Min, to.sat(), {value, constant(1, 1, 1, 1)});
  }
}

void FixedWriter::unlit() {
  if (m_key.needs.primary)
    storeColor(OutputKind::FrontPrimary, attribute(Kind::ColorPrimary));
  if (m_key.needs.secondary)
    storeColor(OutputKind::FrontSecondary, attribute(Kind::ColorSecondary));
}

void FixedWriter::colors() {
  if (m_key.lighting)
    lit();
  else
    unlit();
}

void FixedWriter::texCoords() {
  for (int unit = 0; unit < 8; ++unit) {
    if ((m_key.needs.texCoords >> unit & 1u) == 0)
      continue;
    const fp::ir::Source coordinate = generated(unit);
    const fp::ir::Target to = m_builder.result(OutputKind::TexCoord, unit);
    if ((m_key.textureMatrix >> unit & 1u) == 0) {
      op(Opcode::Mov, to, {coordinate});
      continue;
    }
    for (int row = 0; row < 4; ++row)
      op(Opcode::Dp4, to.mask(fp::ir::kLetters[row]),
         {matrixRow(StateItem::MatrixTexture, unit, row), coordinate});
  }
}

void FixedWriter::fogCoord() {
  if (!m_key.needs.fogCoord)
    return;
  const fp::ir::Target to = m_builder.result(OutputKind::FogCoord).mask("x");
  switch (m_key.fogFrom) {
  case FogFrom::AbsoluteDepth:
    op(Opcode::Abs, to, {eye().swz("z")});
    break;
  case FogFrom::Depth:
    op(Opcode::Mov, to, {eye().swz("z")});
    break;
  case FogFrom::Distance: {
    const fp::ir::Target root = temporary();
    const fp::ir::Source squared = square(eye());
    op(Opcode::Rsq, root.mask("x"), {squared.swz("x")});
    op(Opcode::Mul, to, {squared.swz("x"), root.read().swz("x")});
    break;
  }
  case FogFrom::AbsoluteCoordinate:
    op(Opcode::Abs, to, {attribute(Kind::FogCoord).swz("x")});
    break;
  case FogFrom::Coordinate:
    op(Opcode::Mov, to, {attribute(Kind::FogCoord).swz("x")});
  }
}

/// Writes size * sqrt(1 / (a + b*d + c*d*d)), clamped (3.3). Hosts use depth in place of the
/// distance, as NVIDIA's driver and Mesa do, and the rasterizer's points must have the same size.
void FixedWriter::pointSize() {
  if (!m_key.pointAttenuation)
    return;
  const fp::ir::Source size = state(StateItem::PointSize),
                       factors = state(StateItem::PointAttenuation);
  const fp::ir::Target t = temporary();
  op(Opcode::Abs, t.mask("y"), {eye().swz("z")});
  op(Opcode::Mad, t.mask("z"), {factors.swz("z"), t.read().swz("y"), factors.swz("y")});
  op(Opcode::Mad, t.mask("z"), {t.read().swz("z"), t.read().swz("y"), factors.swz("x")});
  op(Opcode::Rsq, t.mask("w"), {t.read().swz("z")});
  op(Opcode::Mul, t.mask("w"), {t.read().swz("w"), size.swz("x")});
  op(Opcode::Max, t.mask("w"), {t.read().swz("w"), size.swz("y")});
  // The smallest size of points on hosts (OpenGL 2.1, 3.3).
  op(Opcode::Max, t.mask("w"), {t.read().swz("w"), constant(1, 1, 1, 1)});
  op(Opcode::Min, m_builder.result(OutputKind::PointSize).mask("x"),
     {t.read().swz("w"), size.swz("z")});
}

fp::ir::Program makeFixedVertexProgram(const FixedVertexKey &key) {
  FixedWriter writer(key);
  writer.position();
  writer.colors();
  writer.texCoords();
  writer.fogCoord();
  writer.pointSize();
  return writer.take();
}

const std::shared_ptr<const fp::ir::Program> &FixedVertexPrograms::get(const VertexState &state,
                                                                       const VertexNeeds &needs) {
  if (m_last && m_lastVersion == state.version && m_lastNeeds == needs) [[likely]]
    return *m_last;
  m_last = &m_programs.get(fixedVertexKey(state, needs), makeFixedVertexProgram);
  m_lastVersion = state.version;
  m_lastNeeds = needs;
  return *m_last;
}

} // namespace arbiter::state
