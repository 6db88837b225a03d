#include "fp_compiler/testing/generator.h"

#include <cmath>
#include <limits>

namespace arbiter::fp::testing {

using namespace ir;

Target Generator::newTemporary() {
  m_ranges.push_back({});
  m_written.push_back(0);
  m_temporaries.push_back(m_builder.temporary());
  return m_temporaries.back();
}

float Generator::literal() {
  if (m_options.wild && m_random.chance(25)) {
    constexpr std::array kWild = {
        0.0f,   -0.0f,  1e38f, -3e38f, 1e-40f,
        1e-38f, 128.0f, -1.0f, 1e9f,   std::numeric_limits<float>::infinity()};
    return kWild[std::size_t(m_random.below(int(kWild.size())))];
  }
  constexpr std::array kUsual = {0.0f, 1.0f, -1.0f, 0.5f, 2.0f, 0.25f};
  return m_random.chance(40) ? kUsual[std::size_t(m_random.below(int(kUsual.size())))]
                             : m_random.real(-2.0f, 2.0f);
}

StateRef Generator::stateRef() {
  StateRef ref;
  ref.item = StateItem(m_random.below(int(StateItem::MatrixProgram) + 1));
  if (ref.item == StateItem::MatrixPalette)
    ref.item = StateItem::MatrixMvp;
  const bool matrix = ref.item >= StateItem::MatrixModelview;
  const bool lit =
      (ref.item >= StateItem::LightAmbient && ref.item <= StateItem::LightHalf) ||
      (ref.item >= StateItem::LightProdAmbient && ref.item <= StateItem::LightProdSpecular);
  if (lit || ref.item == StateItem::TexEnvColor || ref.item == StateItem::MatrixTexture ||
      ref.item == StateItem::MatrixProgram)
    ref.index = std::uint8_t(m_random.below(2));
  if (matrix) {
    ref.modifier = MatrixModifier(m_random.below(4));
    ref.row = std::uint8_t(m_random.below(4));
  } else if (ref.item <= StateItem::MaterialShininess ||
             ref.item == StateItem::LightModelSceneColor ||
             (ref.item >= StateItem::LightProdAmbient &&
              ref.item <= StateItem::LightProdSpecular)) {
    ref.back = m_random.chance(30);
  }
  return ref;
}

Generator::Picked Generator::parameter() {
  const int kind = m_random.below(10);
  if (kind < 5) {
    Vec4 value = {literal(), literal(), literal(), literal()};
    if (m_random.chance(40))
      value.fill(value[0]);
    Picked result{m_builder.constant(value[0], value[1], value[2], value[3]), {}};
    for (std::size_t i = 0; i < 4; ++i)
      result.ranges[i] = {value[i], value[i]};
    return result;
  }
  Picked result{kind < 7   ? m_builder.local(m_random.below(16))
                : kind < 9 ? m_builder.env(m_random.below(16))
                           : m_builder.state(stateRef()),
                {}};
  result.ranges.fill({InputRanges::kParameterLow, InputRanges::kParameterHigh});
  return result;
}

std::optional<std::size_t> Generator::readableTemporary() {
  for (int tries = 0; tries < 4; ++tries) {
    const auto index = std::size_t(m_random.below(int(m_temporaries.size())));
    if (m_written[index] || ((m_options.wild || m_options.unwritten) && m_random.chance(10)))
      return index;
  }
  return {};
}

Generator::Picked Generator::operand(bool scalar, bool extended) {
  Picked picked;
  std::uint8_t readable = 0xF;
  const auto index = m_random.chance(60) ? readableTemporary() : std::nullopt;
  if (index) {
    picked = {m_temporaries[*index].read(), m_ranges[*index]};
    readable = m_options.wild || m_options.unwritten ? 0xF : m_written[*index];
  } else {
    picked = m_random.chance(45) ? attribute() : parameter();
  }
  swizzle(picked, readable, scalar, extended);
  return picked;
}

void Generator::swizzle(Picked &picked, std::uint8_t readable, bool scalar, bool extended) {
  const bool identity = !scalar && readable == 0xF && m_random.chance(50);
  const bool one = scalar || m_random.chance(25);
  std::array<Select, 4> chosen = kIdentity;
  if (!identity) {
    for (auto &select : chosen)
      do
        select = Select(m_random.below(4));
      while (!(readable >> int(select) & 1));
    if (one)
      chosen.fill(chosen[0]);
  }
  std::uint8_t negate = m_random.chance(20) ? 0xF : 0;
  if (extended) {
    for (auto &select : chosen)
      if (m_random.chance(30))
        select = m_random.chance(50) ? Select::Zero : Select::One;
    negate = std::uint8_t(m_random.below(16));
  }
  const Intervals from = picked.ranges;
  for (std::size_t i = 0; i < 4; ++i) {
    const Select select = chosen[i];
    Interval range = select == Select::Zero  ? Interval{0, 0}
                     : select == Select::One ? Interval{1, 1}
                                             : from[std::size_t(select)];
    picked.ranges[i] = negate >> i & 1 ? -range : range;
  }
  picked.source.swizzle = chosen;
  picked.source.negate = negate;
}

void Generator::clamp(const Destination &dst, float lo, float hi) {
  Target target;
  static_cast<Destination &>(target) = dst;
  target.saturate = false;
  m_builder.op(Opcode::Max, target, {target.read(), m_builder.constant(lo)});
  m_builder.op(Opcode::Min, target, {target.read(), m_builder.constant(hi)});
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      m_ranges[dst.index][i] = {std::max(m_ranges[dst.index][i].lo, lo),
                                std::min(m_ranges[dst.index][i].hi, hi)};
}

Generator::Picked Generator::scalarWithin(float lo, float hi) {
  Picked picked = operand(true, false);
  if (m_options.wild || (picked.ranges[0].lo >= lo && picked.ranges[0].hi <= hi))
    return picked;
  const std::size_t index = std::size_t(m_random.below(int(m_temporaries.size())));
  const Target t = m_temporaries[index];
  if (saturates()) {
    m_builder.op(Opcode::Mov, t.mask("w").sat(), {picked.source});
  } else {
    m_builder.op(Opcode::Mov, t.mask("w"), {picked.source});
    m_ranges[index][3] = picked.ranges[0];
    clamp(t.mask("w"), 0.0f, 1.0f);
  }
  m_builder.op(
      Opcode::Mad, t.mask("w"),
      {t.read().swz("w"), m_builder.constant(hi - lo).swz("w"), m_builder.constant(lo).swz("w")});
  m_written[index] |= 8;
  m_ranges[index][3] = {lo, hi};
  Picked result{t.read().swz("w"), {}};
  result.ranges.fill({lo, hi});
  return result;
}

std::vector<Generator::Picked> Generator::operandsOf(Opcode op) {
  switch (op) {
  case Opcode::Cos:
  case Opcode::Sin:
    return {scalarWithin(-12, 12)};
  case Opcode::Scs:
    return {scalarWithin(-3, 3)};
  case Opcode::Ex2:
  case Opcode::Exp:
    return {scalarWithin(-6, 4)};
  case Opcode::Lg2:
  case Opcode::Log:
  case Opcode::Rcp:
  case Opcode::Rsq:
    return {scalarWithin(0.1f, 8)};
  case Opcode::Pow: {
    Picked base = scalarWithin(0.05f, 2);
    // Clamping the exponent may overwrite the register that the base is read from.
    if (!m_options.wild) {
      const Picked exponent = parameter();
      Picked scalar = exponent;
      swizzle(scalar, 0xF, true, false);
      return {base, scalar};
    }
    return {base, operand(true, false)};
  }
  default:
    break;
  }
  std::vector<Picked> result;
  result.reserve(std::size_t(info(op).operandCount()));
  for (int i = 0; i < info(op).operandCount(); ++i)
    result.push_back(operand(false, op == Opcode::Swz));
  return result;
}

void Generator::emit(Opcode op, const Destination &dst, const std::vector<Picked> &picked) {
  Target target;
  static_cast<Destination &>(target) = dst;
  switch (picked.size()) {
  case 1:
    m_builder.op(op, target, {picked[0].source});
    break;
  case 2:
    m_builder.op(op, target, {picked[0].source, picked[1].source});
    break;
  default:
    m_builder.op(op, target, {picked[0].source, picked[1].source, picked[2].source});
  }
}

void Generator::arithmetic(Opcode op) {
  const std::vector<Picked> picked = operandsOf(op);
  std::array<Intervals, 3> ranges = {};
  for (std::size_t i = 0; i < picked.size(); ++i)
    ranges[i] = picked[i].ranges;
  // LIT's 0^0 is 1 in the specifications, but a host's own path may give 0.
  const bool zeroToZero = ranges[0][1].lo <= 0 && ranges[0][3].lo <= 0 && ranges[0][3].hi >= 0;
  if (op == Opcode::Lit && zeroToZero && !m_options.wild)
    op = Opcode::Abs;
  Destination dst = destination(op);
  const Intervals result = rangesOf(op, ranges);
  bool large = false;
  for (const Interval &range : result)
    large |= !m_options.wild && !(range.magnitude() <= 64.0f);
  dst.saturate |= large && saturates();
  emit(op, dst, picked);
  record(dst, result);
  if (large && !saturates())
    clamp(dst, -8.0f, 8.0f);
}

Destination Generator::destination(Opcode op) {
  Destination dst = m_temporaries[std::size_t(m_random.below(int(m_temporaries.size())))];
  dst.mask = m_random.chance(45) ? 0xF : std::uint8_t(1 + m_random.below(15));
  if (!m_options.wild && op == Opcode::Scs)
    dst.mask = std::uint8_t(1 + m_random.below(3));
  if (!m_options.wild && op == Opcode::Xpd)
    dst.mask = std::uint8_t(1 + m_random.below(7));
  dst.saturate = saturates() && m_random.chance(15);
  return dst;
}

void Generator::record(const Destination &dst, const Intervals &result) {
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      m_ranges[dst.index][i] = dst.saturate ? result[i].saturated() : result[i];
  m_written[dst.index] |= dst.mask;
}

} // namespace arbiter::fp::testing
