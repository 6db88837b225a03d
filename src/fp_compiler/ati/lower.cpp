#include "fp_compiler/ati/lower.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::ati {

namespace {

using ir::Opcode;
using ir::Target;

/// Returns the components that `op`, writing `mask`, reads of its argument `at`.
std::uint8_t componentsOf(const Operation &op, std::uint8_t mask, int at) {
  switch (op.op) {
  case Op::Dot3:
    return 7;
  case Op::Dot4:
    return 0xF;
  case Op::Dot2Add:
    return at < 2 ? 3 : 4;
  case Op::Mov:
  case Op::Add:
  case Op::Mul:
  case Op::Sub:
  case Op::Mad:
  case Op::Lerp:
  case Op::Cnd:
  case Op::Cnd0:
    break;
  }
  return mask;
}

/// True if `op`, writing `mask`, reads a component in `written` of the register.
bool reads(const Operation &op, std::uint8_t mask, std::uint8_t reg, std::uint8_t written) {
  for (int i = 0; i < argumentCount(op.op); ++i) {
    const Argument &argument = op.arguments[std::size_t(i)];
    if (argument.source != Source::Register || argument.index != reg)
      continue;
    const std::uint8_t components = argument.replicate == Replicate::None
                                        ? componentsOf(op, mask, i)
                                        : std::uint8_t(1 << (int(argument.replicate) - 1));
    if (components & written)
      return true;
  }
  return false;
}

float factor(Scale scale) {
  constexpr float kFactors[] = {1.0f, 2.0f, 4.0f, 8.0f, 0.5f, 0.25f, 0.125f};
  return kFactors[std::size_t(scale)];
}

class Lowering {
public:
  Lowering(const Shader &shader, const LowerOptions &options)
      : m_shader(shader), m_range(float(options.registerRange)),
        m_clampConstants(options.clampConstants) {}

  ir::Program run() {
    for (int i = 0; i < m_shader.passCount; ++i)
      pass(m_shader.passes[std::size_t(i)], i + 1 == m_shader.passCount);
    const ir::Source result = m_shader.passCount == 0 ? literal(0.0f) : registerOf(0).read();
    m_builder.op(Opcode::Mov, m_builder.color(), {result});
    ir::Program program = m_builder.take();
    program.language = ir::Language::AtiFragment;
    return program;
  }

private:
  using Registers = std::array<std::optional<Target>, kRegisters>;

  /// Emits one pass. Each pass has registers of its own, so that values not passed on by a setup
  /// are lost. Setups that exchange registers then need no particular order.
  void pass(const Pass &pass, bool last) {
    m_before = std::exchange(m_registers, {});
    m_prefix = last ? "r" : "pre";
    for (std::size_t i = 0; i < pass.setups.size(); ++i)
      spanned(pass.setups[i].span, [&] { setup(pass.setups[i], std::uint8_t(i)); });
    for (std::size_t i = 0; i < pass.pairCount; ++i)
      spanned(pass.pairs[i].span, [&] { pair(pass.pairs[i]); });
  }

  template <typename Emit> void spanned(Span span, Emit emit) {
    const std::size_t first = m_builder.program().code.size();
    emit();
    m_builder.setSpan(first, span);
  }

  Target registerOf(std::uint8_t index) { return registerOf(m_registers, m_prefix, index); }

  Target registerOf(Registers &registers, const char *prefix, std::uint8_t index) {
    std::optional<Target> &found = registers[index];
    if (!found)
      found = m_builder.temporary(prefix + std::to_string(index));
    return *found;
  }

  ir::Source literal(float value) {
    const auto found = std::find_if(m_literals.begin(), m_literals.end(),
                                    [&](const auto &entry) { return entry.first == value; });
    if (found != m_literals.end())
      return found->second;
    return m_literals.emplace_back(value, m_builder.constant(value)).second;
  }

  void setup(const Setup &setup, std::uint8_t index) {
    if (setup.kind == SetupKind::None)
      return;
    const ir::Source from = setup.fromRegister
                                ? registerOf(m_before, "pre", setup.source).read()
                                : m_builder.attribute(ir::AttributeKind::TexCoord, setup.source);
    const Target to = registerOf(index);
    if (setup.kind == SetupKind::SampleMap)
      sampleMap(setup, from, to, index);
    else
      passTexCoord(setup, from, to.mask("xyz"));
  }

  void sampleMap(const Setup &setup, const ir::Source &from, const Target &to, std::uint8_t unit) {
    const auto sample = [&](Opcode op, const char *coordinate) {
      clamped(to, false, [&](const Target &result) {
        m_builder.tex(op, result, from.swz(coordinate), unit, ir::TexTarget::Tex2D);
      });
    };
    switch (setup.coordinates) {
    case Coordinates::Str:
      return sample(Opcode::Tex, "xyzw");
    case Coordinates::Stq:
      return sample(Opcode::Tex, "xyww");
    case Coordinates::StrDr:
      return sample(Opcode::Txp, "xy1z");
    case Coordinates::StqDq:
      return sample(Opcode::Txp, "xy1w");
    }
  }

  void passTexCoord(const Setup &setup, const ir::Source &from, const Target &to) {
    const bool q = setup.coordinates == Coordinates::Stq || setup.coordinates == Coordinates::StqDq;
    clamped(to, false, [&](const Target &result) {
      if (setup.coordinates == Coordinates::Str || setup.coordinates == Coordinates::Stq) {
        m_builder.op(Opcode::Mov, result, {from.swz(q ? "xyww" : "xyzw")});
        return;
      }
      // s/r is computed as s * (1/r): (s, t, 1) * (1/r).
      const Target inverse = scratch();
      m_builder.op(Opcode::Rcp, inverse.mask("x"), {from.swz(q ? "w" : "z")});
      m_builder.op(Opcode::Mul, result, {from.swz("xy11"), inverse.read().swz("x")});
    });
  }

  void pair(const Pair &pair) {
    if (!pair.color || !pair.alpha) {
      if (pair.color)
        operation(*pair.color, registerOf(pair.color->destination), pair.color->mask);
      if (pair.alpha)
        operation(*pair.alpha, registerOf(pair.alpha->destination), kAlpha);
      return;
    }
    const Operation &color = *pair.color;
    Operation alpha = *pair.alpha;
    if (isDot(alpha.op))
      alpha.arguments = color.arguments;
    Operation same = color;
    same.mask = alpha.mask;
    const Target colorTo = registerOf(color.destination);
    const Target alphaTo = registerOf(alpha.destination);
    if (same == alpha) {
      operation(color, colorTo, color.mask | kAlpha);
    } else if (!reads(alpha, kAlpha, color.destination, color.mask)) {
      operation(color, colorTo, color.mask);
      operation(alpha, alphaTo, kAlpha);
    } else if (!reads(color, color.mask, alpha.destination, kAlpha)) {
      operation(alpha, alphaTo, kAlpha);
      operation(color, colorTo, color.mask);
    } else {
      const Target latched = scratch();
      operation(alpha, latched, kAlpha);
      operation(color, colorTo, color.mask);
      m_builder.op(Opcode::Mov, alphaTo.mask("w"), {latched.read()});
    }
  }

  void operation(const Operation &op, const Target &to, std::uint8_t mask) {
    const Target masked = withMask(to, mask);
    std::array<ir::Source, 3> arguments;
    for (int i = 0; i < argumentCount(op.op); ++i)
      arguments[std::size_t(i)] = argument(op.arguments[std::size_t(i)], componentsOf(op, mask, i));
    clamped(masked, op.saturate, [&](const Target &result) {
      if (op.scale == Scale::None)
        return arithmetic(op.op, result, arguments);
      const Target raw = withMask(scratch(), mask);
      arithmetic(op.op, raw, arguments);
      m_builder.op(Opcode::Mul, result, {raw.read(), literal(factor(op.scale))});
    });
  }

  void arithmetic(Op op, const Target &to, const std::array<ir::Source, 3> &a) {
    switch (op) {
    case Op::Mov:
      m_builder.op(Opcode::Mov, to, {a[0]});
      return;
    case Op::Add:
      m_builder.op(Opcode::Add, to, {a[0], a[1]});
      return;
    case Op::Mul:
      m_builder.op(Opcode::Mul, to, {a[0], a[1]});
      return;
    case Op::Sub:
      m_builder.op(Opcode::Sub, to, {a[0], a[1]});
      return;
    case Op::Dot3:
      m_builder.op(Opcode::Dp3, to, {a[0], a[1]});
      return;
    case Op::Dot4:
      m_builder.op(Opcode::Dp4, to, {a[0], a[1]});
      return;
    case Op::Mad:
      m_builder.op(Opcode::Mad, to, {a[0], a[1], a[2]});
      return;
    case Op::Lerp:
      m_builder.op(Opcode::Lrp, to, {a[0], a[1], a[2]});
      return;
    case Op::Cnd: { // a3 > 0.5 is 0.5 - a3 < 0: a float difference has the exact sign
      const Target difference = withMask(scratch(), to.Destination::mask);
      m_builder.op(Opcode::Sub, difference, {literal(0.5f), a[2]});
      m_builder.op(Opcode::Cmp, to, {difference.read(), a[0], a[1]});
      return;
    }
    case Op::Cnd0: // NaN is not below zero
      m_builder.op(Opcode::Cmp, to, {a[2], a[1], a[0]});
      return;
    case Op::Dot2Add: {
      const Target sum = scratch().mask("x");
      m_builder.op(Opcode::Mul, sum, {a[0].swz("x"), a[1].swz("x")});
      m_builder.op(Opcode::Mad, sum, {a[0].swz("y"), a[1].swz("y"), sum.read().swz("x")});
      m_builder.op(Opcode::Add, to, {sum.read().swz("x"), a[2].swz("z")});
      return;
    }
    }
  }

  /// Returns the argument's value in the components of `mask`.
  ir::Source argument(const Argument &argument, std::uint8_t mask) {
    ir::Source value = source(argument);
    if (argument.replicate != Replicate::None) {
      value = value.swz(ir::kLetters[std::size_t(argument.replicate) - 1]);
    }
    const auto step = [&](Opcode op, const ir::Source &a, const ir::Source &b) {
      const Target to = withMask(scratch(), mask);
      m_builder.op(op, to, {a, b});
      value = to.read();
    };
    if (argument.complement)
      step(Opcode::Sub, literal(1.0f), value);
    if (argument.bias)
      step(Opcode::Sub, value, literal(0.5f));
    if (argument.twice)
      step(Opcode::Mul, value, literal(2.0f));
    return argument.negate ? -value : value;
  }

  ir::Source source(const Argument &argument) {
    switch (argument.source) {
    case Source::Register:
      return registerOf(argument.index).read();
    case Source::Constant:
      return constant(argument.index);
    case Source::Zero:
      return literal(0.0f);
    case Source::One:
      return literal(1.0f);
    case Source::Primary:
      return m_builder.attribute(ir::AttributeKind::ColorPrimary);
    case Source::Secondary:
      break;
    }
    return m_builder.attribute(ir::AttributeKind::ColorSecondary);
  }

  /// Returns a constant, clamped to [0,1] if the options say so. The clamp is emitted once, at the
  /// first read.
  ir::Source constant(std::uint8_t index) {
    std::optional<ir::Source> &known = m_constants[index];
    if (known)
      return *known;
    const Constant &row = m_shader.constants[index];
    if (row.kind == ConstantKind::Value) {
      ir::Vec4 value = row.value;
      if (m_clampConstants)
        std::transform(value.begin(), value.end(), value.begin(), ir::saturated);
      known = m_builder.constant(value[0], value[1], value[2], value[3]);
      return *known;
    }
    const ir::Source raw =
        row.kind == ConstantKind::Env ? m_builder.env(row.index) : m_builder.local(row.index);
    if (!m_clampConstants) {
      known = raw;
      return *known;
    }
    const Target to = m_builder.temporary("c" + std::to_string(index));
    m_builder.op(Opcode::Mov, to.sat(), {raw});
    known = to.read();
    return *known;
  }

  /// Calls `emit` with the register to write and clamps its result on the way to `to`. The clamp is
  /// to [0,1], or to the register range if there is one.
  template <typename Emit> void clamped(const Target &to, bool saturate, Emit emit) {
    if (saturate || m_range == 0.0f)
      return emit(saturate ? to.sat() : to);
    const Target wide = withMask(scratch(), to.Destination::mask);
    emit(wide);
    m_builder.op(Opcode::Max, wide, {wide.read(), literal(-m_range)});
    m_builder.op(Opcode::Min, to, {wide.read(), literal(m_range)});
  }

  Target scratch() { return m_builder.temporary(); }

  const Shader &m_shader;
  float m_range;
  bool m_clampConstants;
  ir::Builder m_builder;
  Registers m_registers; ///< of the current pass; empty until used
  Registers m_before;    ///< of the previous pass
  const char *m_prefix = "r";
  std::vector<std::pair<float, ir::Source>> m_literals;
  std::array<std::optional<ir::Source>, kConstants> m_constants;
};

} // namespace

ir::Program lower(const Shader &shader, const LowerOptions &options) {
  return Lowering(shader, options).run();
}

} // namespace arbiter::fp::ati
