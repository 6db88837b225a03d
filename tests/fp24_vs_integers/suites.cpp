#include "suites.h"

#include <bit>
#include <cmath>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"
#include "reference.h"

namespace arbiter::fp::proof {

using ir::Opcode;
using ir::Vec4;
using testing::Random;
using testing::sameBits;

namespace {
std::string text(float value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%a", double(value));
  return buffer;
}
std::string text(const Vec4 &value) {
  return "(" + text(value[0]) + ", " + text(value[1]) + ", " + text(value[2]) + ", " +
         text(value[3]) + ")";
}

/// Counts one comparison; \p describe returns the description of a difference.
template <typename Value, typename Describe>
void judge(Row &row, const Value &got, const Value &wanted, bool open, Describe describe) {
  ++row.cases;
  if (sameBits(got, wanted))
    return;
  ++(open ? row.open : row.different);
  if (!open && row.first.empty())
    row.first = describe() + ": " + text(got) + ", not " + text(wanted);
}

void judge(Row &row, float argument, float got, float wanted) {
  judge(row, got, wanted, false, [&] { return text(argument); });
}

/// Calls \p visit for every stride-th number below \p count and shows the progress.
template <typename Visit>
void each(const Settings &settings, const std::string &name, std::uint64_t count,
          std::uint64_t stride, Visit visit) {
  std::uint64_t visited = 0;
  for (std::uint64_t i = 0; i < count; i += stride) {
    visit(i);
    if (settings.progress && (++visited & 0xFFFF) == 0)
      settings.progress(name, double(i) / double(count));
  }
}

float single(std::uint64_t bits) { return std::bit_cast<float>(std::uint32_t(bits)); }

/// Visits every exponent with mantissas at its ends and in the middle, and all values of the bits
/// that are rounded off.
template <typename Visit> void turningPoints(Visit visit) {
  for (std::uint32_t head = 0; head < 512; ++head)
    for (const std::uint32_t mantissa : {0u, 1u, 2u, 0x7FFFu, 0x8000u, 0xFFFEu, 0xFFFFu})
      for (std::uint32_t rest = 0; rest < 128; ++rest)
        visit(single(head << 23 | mantissa << 7 | rest));
}

constexpr Opcode kUnary[] = {Opcode::Abs, Opcode::Cos, Opcode::Ex2, Opcode::Flr,
                             Opcode::Frc, Opcode::Lg2, Opcode::Mov, Opcode::Rcp,
                             Opcode::Rsq, Opcode::Scs, Opcode::Sin};

/// Returns a 24-bit float: any pattern, one of moderate size (so that sums lose bits), or one at
/// which a rule changes.
float anyNumber(Random &random) {
  const int kind = random.below(100);
  if (kind < 35)
    return valueOf(std::uint32_t(random.below(int(kPatterns))));
  if (kind < 85)
    return valueOf(std::uint32_t(random.below(2)) << 23 |
                   std::uint32_t(51 + random.below(25)) << 16 |
                   std::uint32_t(random.below(0x10000)));
  return nearest(
      double(testing::kSpecials[std::size_t(random.below(int(testing::kSpecials.size())))]));
}

Vec4 anyVector(Random &random) {
  return {anyNumber(random), anyNumber(random), anyNumber(random), anyNumber(random)};
}

bool isArithmetic(Opcode op) {
  const ir::OpInfo &row = ir::info(op);
  return !row.has(ir::Texture) && !row.has(ir::Kills) && !row.has(ir::VertexOnly);
}

std::string nameOf(Opcode op) { return std::string(ir::info(op).mnemonic); }
} // namespace

Rows formats(const Settings &settings) {
  Row patterns{"patterns stay", 0, 0, 0, {}};
  each(settings, patterns.name, kPatterns, settings.stride, [&](std::uint64_t i) {
    const float value = valueOf(std::uint32_t(i));
    judge(patterns, value, fp24::rounded(value), value);
    judge(patterns, value, fp24::truncated(value), value);
  });
  Row rounded{"rounded", 0, 0, 0, {}}, truncated{"truncated", 0, 0, 0, {}},
      colors{"colour", 0, 0, 0, {}};
  const auto visit = [&](float value) {
    judge(rounded, value, fp24::rounded(value), nearest(double(value)));
    judge(truncated, value, fp24::truncated(value), towardZero(double(value)));
    judge(colors, value, fp24::color(value), color(value));
  };
  turningPoints(visit);
  each(settings, "all singles", std::uint64_t(1) << 32, settings.stride,
       [&](std::uint64_t i) { visit(single(i)); });
  return {patterns, rounded, truncated, colors};
}

Rows unary(const Settings &settings) {
  Rows rows;
  for (const Opcode op : kUnary) {
    Row row{nameOf(op), 0, 0, 0, {}};
    each(settings, row.name, kPatterns, settings.stride, [&](std::uint64_t i) {
      const float x = valueOf(std::uint32_t(i));
      const ir::Operands operands = {Vec4{x, x, x, x}};
      const Result wanted = reference(op, operands);
      judge(row, ir::apply(op, operands, Numerics::Fp24), wanted.value, wanted.open,
            [&] { return text(x); });
    });
    rows.push_back(row);
  }
  Row saturate{"_SAT", 0, 0, 0, {}};
  each(settings, saturate.name, kPatterns, settings.stride, [&](std::uint64_t i) {
    const float x = valueOf(std::uint32_t(i));
    judge(saturate, x, ir::saturated(x), x > 0 ? (x > 1 ? 1 : x) : 0);
  });
  rows.push_back(saturate);
  return rows;
}

Rows sampled(const Settings &settings) {
  Rows rows;
  for (int o = 0; o < ir::kOpcodeCount; ++o) {
    const auto op = Opcode(o);
    if (!isArithmetic(op))
      continue;
    Random random(settings.seed * 1000 + std::uint64_t(o));
    Row row{nameOf(op), 0, 0, 0, {}};
    each(settings, row.name, settings.samples, 1, [&](std::uint64_t) {
      const ir::Operands operands = {anyVector(random), anyVector(random), anyVector(random)};
      const Result wanted = reference(op, operands);
      judge(row, ir::apply(op, operands, Numerics::Fp24), wanted.value, wanted.open,
            [&] { return text(operands[0]) + " " + text(operands[1]) + " " + text(operands[2]); });
    });
    rows.push_back(row);
  }
  return rows;
}

namespace {
/// One instruction on registers of every kind, the numbers in them, and the expected result.
class OneInstruction {
public:
  explicit OneInstruction(std::uint64_t seed) : m_random(seed) {}

  void run(Row &row) {
    ir::Builder builder;
    do
      m_op = Opcode(m_random.below(ir::kOpcodeCount));
    while (!isArithmetic(m_op));
    const bool saturate = m_random.chance(25);
    const ir::OpInfo &info = ir::info(m_op);
    ir::Operands read = {};
    std::vector<ir::Source> sources;
    for (int i = 0; i < info.operandCount(); ++i)
      sources.push_back(operand(builder, info.shapes[std::size_t(i)] == 'S', read[std::size_t(i)]));
    const ir::Target target = saturate ? builder.color().sat() : builder.color();
    if (sources.size() == 1)
      builder.op(m_op, target, {sources[0]});
    else if (sources.size() == 2)
      builder.op(m_op, target, {sources[0], sources[1]});
    else
      builder.op(m_op, target, {sources[0], sources[1], sources[2]});
    const ir::Program program = builder.take();
    ir::Inputs inputs;
    inputs.attributes = m_attributes;
    inputs.parameter = [&](const ir::Parameter &p) { return m_rows[std::size_t(p.index)]; };
    inputs.numerics = Numerics::Fp24;
    Result wanted = reference(m_op, read);
    if (saturate)
      for (float &value : wanted.value)
        value = value > 0 ? (value > 1 ? 1 : value) : 0;
    judge(row, ir::evaluate(program, inputs).outputs.at(0), wanted.value, wanted.open,
          [&] { return nameOf(m_op) + " " + text(read[0]) + " " + text(read[1]); });
  }

private:
  float anySingle() {
    const int kind = m_random.below(100);
    if (kind < 60)
      return anyNumber(m_random) * m_random.real(0.5f, 1.5f);
    if (kind < 80)
      return m_random.real(-0.25f, 1.25f);
    return testing::kSpecials[std::size_t(m_random.below(int(testing::kSpecials.size())))];
  }

  ir::Source operand(ir::Builder &builder, bool scalar, Vec4 &read) {
    Vec4 given = {anySingle(), anySingle(), anySingle(), anySingle()};
    Vec4 held = given;
    ir::Source source;
    const int kind = m_random.below(4);
    if (kind < 2) {
      const auto which = kind == 0 ? ir::AttributeKind::ColorPrimary : ir::AttributeKind::TexCoord;
      source = builder.attribute(which, int(kind == 0 ? 0 : m_random.below(4)));
      if (source.index < m_attributes.size())
        held = m_attributes[source.index];
      else
        m_attributes.push_back(given);
      for (float &value : held)
        value = kind == 0 ? color(value) : nearest(double(value));
    } else {
      if (kind == 2) {
        source = builder.constant(given[0], given[1], given[2], given[3]);
      } else {
        const int row = m_random.below(int(m_rows.size()));
        source = builder.local(row);
        held = m_rows[std::size_t(row)] =
            m_rowSet[std::size_t(row)] ? m_rows[std::size_t(row)] : given;
        m_rowSet[std::size_t(row)] = true;
      }
      for (float &value : held)
        value = towardZero(double(value));
    }
    source.negate = scalar ? (m_random.chance(50) ? 0xF : 0) : std::uint8_t(m_random.below(16));
    const int first = m_random.below(4);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto select = std::size_t(scalar ? first : m_random.below(4));
      source.swizzle[i] = ir::Select(select);
      read[i] = source.negate >> i & 1 ? -held[select] : held[select];
    }
    return source;
  }

  Random m_random;
  Opcode m_op = Opcode::Mov;
  std::vector<Vec4> m_attributes;
  std::array<Vec4, 8> m_rows = {};
  std::array<bool, 8> m_rowSet = {};
};
} // namespace

Rows programs(const Settings &settings) {
  Row row{"programs of one instruction", 0, 0, 0, {}};
  each(settings, row.name, settings.samples, 1,
       [&](std::uint64_t i) { OneInstruction(settings.seed * 1000003 + i).run(row); });
  return {row};
}

} // namespace arbiter::fp::proof
