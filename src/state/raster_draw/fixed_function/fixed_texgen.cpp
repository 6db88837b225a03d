// Writes generated texture coordinates, computed from positions and normals (OpenGL 1.4, 2.10.4).
#include "state/raster_draw/fixed_function/fixed_writer.h"

namespace arbiter::state {

namespace {
bool isMode(std::uint8_t coded, TexGenMode mode) { return coded == 1 + int(mode); }
} // namespace

/// Returns r = u - 2 n (n . u).
fp::ir::Source FixedWriter::reflected() {
  if (m_reflected)
    return *m_reflected;
  const Source n = normal(), u = eyeUnit();
  const Target r = temporary();
  op(Opcode::Dp3, r.mask("w"), {n, u});
  op(Opcode::Add, r.mask("w"), {r.read().swz("w"), r.read().swz("w")});
  op(Opcode::Mul, r.mask("xyz"), {n, r.read().swz("w")});
  op(Opcode::Sub, r.mask("xyz"), {u, r.read()});
  return *(m_reflected = r.read());
}

/// Returns s = rx/m + 1/2 and t = ry/m + 1/2, with m = 2 sqrt(rx^2 + ry^2 + (rz + 1)^2). All units
/// share it.
fp::ir::Source FixedWriter::sphere() {
  if (m_sphere)
    return *m_sphere;
  const Source r = reflected();
  const Target t = temporary(), st = temporary();
  op(Opcode::Add, t.mask("xyz"), {r, constant(0, 0, 1, 0)});
  op(Opcode::Rsq, t.mask("w"), {square(t.read()).swz("x")});
  op(Opcode::Mul, t.mask("w"), {t.read().swz("w"), constant(0.5f, 0.5f, 0.5f, 0.5f)});
  op(Opcode::Mad, st.mask("xy"), {r, t.read().swz("w"), constant(0.5f, 0.5f, 0.5f, 0.5f)});
  return *(m_sphere = st.read());
}

/// Returns a unit's coordinates before its texture matrix.
fp::ir::Source FixedWriter::generated(int unit) {
  const auto &modes = m_key.texGen[std::size_t(unit)];
  const Source given = attribute(Kind::TexCoord, unit);
  if (modes == std::array<std::uint8_t, 4>{})
    return given;
  const Target to = temporary();
  for (int c = 0; c < 4; ++c) {
    const std::uint8_t mode = modes[std::size_t(c)];
    const Target component = to.mask(fp::ir::kLetters[c]);
    if (isMode(mode, TexGenMode::ObjectLinear))
      op(Opcode::Dp4, component,
         {state(StateItem::TexGenObject, unit, c), attribute(Kind::Position)});
    else if (isMode(mode, TexGenMode::EyeLinear))
      op(Opcode::Dp4, component, {state(StateItem::TexGenEye, unit, c), eye()});
    else if (isMode(mode, TexGenMode::Sphere) && c < 2)
      op(Opcode::Mov, component, {sphere()});
    else if (isMode(mode, TexGenMode::Reflection) && c < 3)
      op(Opcode::Mov, component, {reflected()});
    else if (isMode(mode, TexGenMode::Normal) && c < 3)
      op(Opcode::Mov, component, {normal()});
    else
      op(Opcode::Mov, component, {given});
  }
  return to.read();
}

} // namespace arbiter::state
