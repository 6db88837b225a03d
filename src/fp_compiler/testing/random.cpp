#include "fp_compiler/testing/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/interval.h"

namespace arbiter::fp::testing {

using namespace ir;

namespace {
using Intervals = std::array<Interval, 4>;

class Generator {
public:
  Generator(std::uint64_t seed, const RandomOptions &options)
      : m_random(seed), m_options(options) {}

  Program run() {
    chooseOptions();
    for (int i = 2 + m_random.below(5); i > 0; --i)
      newTemporary();
    const int count = m_options.minInstructions +
                      m_random.below(m_options.maxInstructions - m_options.minInstructions + 1);
    for (int i = 0; i < count; ++i)
      statement();
    finish();
    return m_builder.take();
  }

private:
  // Operands ------------------------------------------------------------------------------------
  struct Picked {
    Source source;
    Intervals ranges; ///< after swizzle and sign
  };

  Target newTemporary() {
    m_ranges.push_back({});
    m_written.push_back(0);
    m_temporaries.push_back(m_builder.temporary());
    return m_temporaries.back();
  }

  void chooseOptions() {
    if (!m_options.options)
      return;
    Options &options = m_builder.options();
    if (m_random.chance(12))
      options.fog = FogMode(1 + m_random.below(3));
    if (m_random.chance(20))
      options.precision = Precision(1 + m_random.below(2));
    options.shadow = m_random.chance(25);
    options.drawBuffers = m_random.chance(8) && options.fog == FogMode::None;
    options.originUpperLeft = m_random.chance(6);
    options.pixelCenterInteger = m_random.chance(6);
  }

  Picked attribute() {
    const AttributeKind kind = AttributeKind(m_random.below(5));
    const int index = kind == AttributeKind::TexCoord ? m_random.below(8) : 0;
    Picked result{m_builder.attribute(kind, index), {}};
    for (std::size_t i = 0; i < 4; ++i)
      result.ranges[i] = attributeRange(kind, int(i));
    return result;
  }

  float literal() {
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

  StateRef stateRef() {
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

  Picked parameter() {
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

  std::optional<std::size_t> readableTemporary() {
    for (int tries = 0; tries < 4; ++tries) {
      const auto index = std::size_t(m_random.below(int(m_temporaries.size())));
      if (m_written[index] || (m_options.wild && m_random.chance(10)))
        return index;
    }
    return {};
  }

  Picked operand(bool scalar, bool extended) {
    Picked picked;
    std::uint8_t readable = 0xF;
    const auto index = m_random.chance(60) ? readableTemporary() : std::nullopt;
    if (index) {
      picked = {m_temporaries[*index].read(), m_ranges[*index]};
      readable = m_options.wild ? 0xF : m_written[*index];
    } else {
      picked = m_random.chance(45) ? attribute() : parameter();
    }
    swizzle(picked, readable, scalar, extended);
    return picked;
  }

  void swizzle(Picked &picked, std::uint8_t readable, bool scalar, bool extended) {
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

  /// A scalar operand inside [lo, hi], by MOV_SAT and MAD if it is not there already.
  Picked scalarWithin(float lo, float hi) {
    Picked picked = operand(true, false);
    if (m_options.wild || (picked.ranges[0].lo >= lo && picked.ranges[0].hi <= hi))
      return picked;
    const std::size_t index = std::size_t(m_random.below(int(m_temporaries.size())));
    const Target t = m_temporaries[index];
    m_builder.op(Opcode::Mov, t.mask("w").sat(), {picked.source});
    m_builder.op(
        Opcode::Mad, t.mask("w"),
        {t.read().swz("w"), m_builder.constant(hi - lo).swz("w"), m_builder.constant(lo).swz("w")});
    m_written[index] |= 8;
    m_ranges[index][3] = {lo, hi};
    Picked result{t.read().swz("w"), {}};
    result.ranges.fill({lo, hi});
    return result;
  }

  // Statements ----------------------------------------------------------------------------------
  void statement() {
    const Opcode op = Opcode(m_random.below(kFragmentOpcodeCount));
    const OpInfo &row = info(op);
    if (row.has(Kills))
      kill();
    else if (row.has(Texture) || m_random.chance(10))
      texture();
    else
      arithmetic(op);
  }

  void kill() {
    if (m_options.kills && m_random.chance(40))
      m_builder.kil(operand(m_random.chance(50), false).source);
  }

  void texture() {
    const int unit = m_random.below(m_builder.options().shadow ? 8 : 5);
    const Opcode op = Opcode(int(Opcode::Tex) + m_random.below(3));
    Picked coordinate = operand(false, false);
    const bool tame = coordinate.ranges[3].lo > 0.1f;
    const Opcode used = op == Opcode::Txp && !tame && !m_options.wild ? Opcode::Tex : op;
    Destination dst = destination(used);
    Target target;
    static_cast<Destination &>(target) = dst;
    m_builder.tex(used, target, coordinate.source, unit, kUnitTargets[std::size_t(unit)]);
    Intervals result;
    result.fill({InputRanges::kTexelLow, InputRanges::kTexelHigh});
    record(dst, result);
  }

  std::vector<Picked> operandsOf(Opcode op) {
    switch (op) {
    case Opcode::Cos:
    case Opcode::Sin:
      return {scalarWithin(-12, 12)};
    case Opcode::Scs:
      return {scalarWithin(-3, 3)};
    case Opcode::Ex2:
      return {scalarWithin(-6, 4)};
    case Opcode::Lg2:
    case Opcode::Rcp:
    case Opcode::Rsq:
      return {scalarWithin(0.1f, 8)};
    case Opcode::Pow: {
      Picked base = scalarWithin(0.05f, 2);
      // The guard of the exponent may write the register that the base is read from.
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

  void arithmetic(Opcode op) {
    const std::vector<Picked> picked = operandsOf(op);
    std::array<Intervals, 3> ranges = {};
    for (std::size_t i = 0; i < picked.size(); ++i)
      ranges[i] = picked[i].ranges;
    Destination dst = destination(op);
    const Intervals result = rangesOf(op, ranges);
    for (const Interval &range : result)
      dst.saturate |= !m_options.wild && !(range.magnitude() <= 64.0f);
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
    record(dst, result);
  }

  Destination destination(Opcode op) {
    Destination dst = m_temporaries[std::size_t(m_random.below(int(m_temporaries.size())))];
    dst.mask = m_random.chance(45) ? 0xF : std::uint8_t(1 + m_random.below(15));
    if (!m_options.wild && op == Opcode::Scs)
      dst.mask = std::uint8_t(1 + m_random.below(3));
    if (!m_options.wild && op == Opcode::Xpd)
      dst.mask = std::uint8_t(1 + m_random.below(7));
    dst.saturate = m_random.chance(15);
    return dst;
  }

  void record(const Destination &dst, const Intervals &result) {
    for (std::size_t i = 0; i < 4; ++i)
      if (dst.mask >> i & 1)
        m_ranges[dst.index][i] = dst.saturate ? result[i].saturated() : result[i];
    m_written[dst.index] |= dst.mask;
  }

  /// Every colour is written whole, so that nothing that reaches a pixel is undefined.
  void finish() {
    const int colors = m_builder.options().drawBuffers ? 2 : 1;
    for (int i = 0; i < colors; ++i) {
      const Target color = m_builder.color(i);
      if (m_random.chance(50)) {
        m_builder.op(Opcode::Mov, color, {operand(false, false).source});
      } else {
        m_builder.op(
            Opcode::Mad, color.mask("xyz"),
            {operand(false, false).source, m_builder.constant(0.5f), operand(false, false).source});
        m_builder.op(Opcode::Mov, color.mask("w"), {operand(false, false).source});
      }
    }
    if (m_random.chance(12))
      m_builder.op(Opcode::Mov, m_builder.depth().mask("z").sat(), {operand(false, false).source});
  }

  Random m_random;
  RandomOptions m_options;
  Builder m_builder;
  std::vector<Target> m_temporaries;
  std::vector<Intervals> m_ranges;
  std::vector<std::uint8_t> m_written;
};
} // namespace

Program randomProgram(std::uint64_t seed, const RandomOptions &options) {
  return Generator(seed, options).run();
}

} // namespace arbiter::fp::testing
