#include "fp_compiler/testing/random.h"

#include "fp_compiler/testing/generator.h"

namespace arbiter::fp::testing {

using namespace ir;

namespace {
class FragmentGenerator : public Generator {
public:
  FragmentGenerator(std::uint64_t seed, const RandomOptions &options)
      : Generator(Language::ArbFragment, seed, options) {}

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

  Picked attribute() override {
    const AttributeKind kind = AttributeKind(m_random.below(5));
    const int index = kind == AttributeKind::TexCoord ? m_random.below(8) : 0;
    Picked result{m_builder.attribute(kind, index), {}};
    for (std::size_t i = 0; i < 4; ++i)
      result.ranges[i] = attributeRange(kind, int(i));
    return result;
  }

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

  /// Writes every colour. A tame program writes all components, so that no pixel is undefined.
  void finish() {
    const int colors = m_builder.options().drawBuffers ? 2 : 1;
    for (int i = 0; i < colors; ++i) {
      const Target color = m_builder.color(i);
      if (m_options.unwritten && m_random.chance(50)) {
        Target part = color;
        part.Destination::mask = std::uint8_t(1 + m_random.below(14));
        m_builder.op(Opcode::Mov, part, {operand(false, false).source});
      } else if (m_random.chance(50)) {
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
};
} // namespace

Program randomProgram(std::uint64_t seed, const RandomOptions &options) {
  return FragmentGenerator(seed, options).run();
}

} // namespace arbiter::fp::testing
