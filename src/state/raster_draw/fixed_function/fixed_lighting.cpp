// Writes lighting (OpenGL 1.4, 2.13): the equation of 2.13.1, for each side that may be visible.
#include <bit>

#include "state/raster_draw/fixed_function/fixed_writer.h"

namespace arbiter::state {

using fp::ir::OutputKind;

namespace {
/// The bits of FixedVertexKey::colorMaterialParts and VertexNeeds::frontMaterials.
enum Part : std::uint8_t {
  kEmission = 1,
  kAmbient = 2,
  kDiffuse = 4,
  kSpecular = 8,
  kShininess = 16
};
} // namespace

/// One side of a lit vertex: its sums, and the material parts that track the colour or are
/// attributes.
struct FixedWriter::Side {
  bool back;
  std::uint8_t tracked, own;
  Target primary, secondary; ///< one register unless the specular part is kept apart
};

/// A light as seen from the vertex, the same for both sides.
struct FixedWriter::Ray {
  int light;
  Source direction;             ///< to the light, normalized
  Source half;                  ///< half-way vector between the light and the viewer, normalized
  std::optional<Source> factor; ///< in x: attenuation times spot effect; none: 1
};

fp::ir::Source FixedWriter::materialPart(const Side &side, std::uint8_t part) {
  if ((side.tracked & part) != 0)
    return attribute(Kind::ColorPrimary);
  if ((side.own & part) != 0)
    return attribute(Kind::Generic, materialAttribute(side.back, std::countr_zero(part)));
  const StateItem item = part == kEmission   ? StateItem::MaterialEmission
                         : part == kAmbient  ? StateItem::MaterialAmbient
                         : part == kDiffuse  ? StateItem::MaterialDiffuse
                         : part == kSpecular ? StateItem::MaterialSpecular
                                             : StateItem::MaterialShininess;
  return state(item, 0, 0, side.back);
}

/// Returns material times light.
fp::ir::Source FixedWriter::product(const Side &side, std::uint8_t part, int light) {
  const bool ambient = part == kAmbient, diffuse = part == kDiffuse;
  if (((side.tracked | side.own) & part) == 0)
    return state(ambient   ? StateItem::LightProdAmbient
                 : diffuse ? StateItem::LightProdDiffuse
                           : StateItem::LightProdSpecular,
                 light, 0, side.back);
  const Target result = temporary();
  op(Opcode::Mul, result.mask("xyz"),
     {materialPart(side, part), state(ambient   ? StateItem::LightAmbient
                                      : diffuse ? StateItem::LightDiffuse
                                                : StateItem::LightSpecular,
                                      light)});
  return result.read();
}

/// Starts with emission + model ambient * material ambient. Alpha is the diffuse part's.
void FixedWriter::startSums(Side &side) {
  side.primary = temporary();
  if (((side.tracked | side.own) & (kEmission | kAmbient)) == 0)
    op(Opcode::Mov, side.primary.mask("xyz"),
       {state(StateItem::LightModelSceneColor, 0, 0, side.back)});
  else
    op(Opcode::Mad, side.primary.mask("xyz"),
       {state(StateItem::LightModelAmbient), materialPart(side, kAmbient),
        materialPart(side, kEmission)});
  op(Opcode::Mov, side.primary.mask("w"), {materialPart(side, kDiffuse).swz("w")});
  side.secondary = side.primary;
  if (!m_key.separateSpecular)
    return;
  side.secondary = temporary();
  op(Opcode::Mov, side.secondary, {constant(0, 0, 0, 0)});
}

/// Returns 1 / (k0 + k1 d + k2 d^2). `distance` has d^2 in x and 1/d in w.
fp::ir::Source FixedWriter::attenuation(int light, const Source &distance) {
  const Source k = state(StateItem::LightAttenuation, light);
  const Target t = temporary();
  op(Opcode::Mul, t.mask("y"), {distance.swz("x"), distance.swz("w")});
  op(Opcode::Mad, t.mask("x"), {k.swz("y"), t.read().swz("y"), k.swz("x")});
  op(Opcode::Mad, t.mask("x"), {k.swz("z"), distance.swz("x"), t.read().swz("x")});
  op(Opcode::Rcp, t.mask("x"), {t.read().swz("x")});
  return t.read();
}

/// Returns the cosine to the spot's axis, raised to the spot exponent, or 0 outside of the cone.
fp::ir::Source FixedWriter::spot(int light, const Source &direction) {
  const Source axis = state(StateItem::LightSpotDirection, light);
  const Target t = temporary();
  op(Opcode::Dp3, t.mask("x"), {-direction, normalized(axis)});
  op(Opcode::Sge, t.mask("y"), {t.read().swz("x"), axis.swz("w")});
  op(Opcode::Max, t.mask("x"), {t.read().swz("x"), constant(0, 0, 0, 0)});
  op(Opcode::Pow, t.mask("x"),
     {t.read().swz("x"), state(StateItem::LightAttenuation, light).swz("w")});
  op(Opcode::Mul, t.mask("x"), {t.read().swz("x"), t.read().swz("y")});
  return t.read();
}

FixedWriter::Ray FixedWriter::ray(int light) {
  const auto isSet = [&](std::uint8_t mask) { return (mask >> light & 1u) != 0; };
  const Source position = state(StateItem::LightPosition, light);
  Ray ray{light, {}, {}, {}};
  if (isSet(m_key.positional)) {
    const Target to = temporary(), distance = temporary();
    op(Opcode::Rcp, to.mask("w"), {position.swz("w")});
    op(Opcode::Mad, to.mask("xyz"), {position, to.read().swz("w"), -eye()});
    op(Opcode::Mov, distance.mask("x"), {square(to.read()).swz("x")});
    op(Opcode::Rsq, distance.mask("w"), {distance.read().swz("x")});
    op(Opcode::Mul, to.mask("xyz"), {to.read(), distance.read().swz("w")});
    ray.direction = to.read();
    if (isSet(m_key.attenuated))
      ray.factor = attenuation(light, distance.read());
  } else {
    ray.direction = normalized(position);
  }
  if (isSet(m_key.spots)) {
    const Source cone = spot(light, ray.direction);
    if (ray.factor) {
      const Target both = temporary();
      op(Opcode::Mul, both.mask("x"), {ray.factor->swz("x"), cone.swz("x")});
      ray.factor = both.read();
    } else {
      ray.factor = cone;
    }
  }
  const Target sum = temporary();
  if (m_key.localViewer)
    op(Opcode::Sub, sum.mask("xyz"), {ray.direction, eyeUnit()});
  else
    op(Opcode::Add, sum.mask("xyz"), {ray.direction, constant(0, 0, 1, 0)});
  ray.half = normalized(sum.read());
  return ray;
}

void FixedWriter::addLight(const Side &side, const Ray &ray) {
  const Source n = side.back ? -normal() : normal();
  const Target t = temporary(), lit = temporary();
  op(Opcode::Dp3, t.mask("x"), {n, ray.direction});
  op(Opcode::Dp3, t.mask("y"), {n, ray.half});
  op(Opcode::Mov, t.mask("w"), {materialPart(side, kShininess).swz("x")});
  op(Opcode::Lit, lit, {t.read()});
  if (ray.factor) // applies to all three terms; lit.x is 1
    op(Opcode::Mul, lit.mask("xyz"), {lit.read(), ray.factor->swz("x")});
  const auto add = [&](std::uint8_t part, std::string_view weight, const Target &sum) {
    op(Opcode::Mad, sum.mask("xyz"),
       {lit.read().swz(weight), product(side, part, ray.light), sum.read()});
  };
  add(kAmbient, "x", side.primary);
  add(kDiffuse, "y", side.primary);
  add(kSpecular, "z", side.secondary);
}

void FixedWriter::storeSums(const Side &side) {
  if (m_key.needs.primary)
    storeColor(side.back ? OutputKind::BackPrimary : OutputKind::FrontPrimary, side.primary.read());
  if (m_key.needs.secondary)
    storeColor(side.back ? OutputKind::BackSecondary : OutputKind::FrontSecondary,
               m_key.separateSpecular ? side.secondary.read() : constant(0, 0, 0, 0));
}

void FixedWriter::lit() {
  Ray rays[8];
  for (int light = 0; light < 8; ++light)
    if ((m_key.lights >> light & 1u) != 0)
      rays[light] = ray(light);
  for (int back = 0; back <= (m_key.twoSided ? 1 : 0); ++back) {
    const bool tracks = (m_key.colorMaterialFace >> back & 1u) != 0;
    Side side{back != 0,
              tracks ? m_key.colorMaterialParts : std::uint8_t(0),
              back != 0 ? m_key.needs.backMaterials : m_key.needs.frontMaterials,
              {},
              {}};
    startSums(side);
    for (int light = 0; light < 8; ++light)
      if ((m_key.lights >> light & 1u) != 0)
        addLight(side, rays[light]);
    storeSums(side);
  }
}

} // namespace arbiter::state
