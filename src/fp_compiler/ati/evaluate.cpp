#include "fp_compiler/ati/evaluate.h"

#include <cfloat>
#include <cmath>

namespace arbiter::fp::ati {

namespace {

using ir::Vec4;
using RegisterValues = std::array<Vec4, kRegisters>;

float flush(float x) { return std::fabs(x) < FLT_MIN ? std::copysign(0.0f, x) : x; }

/// Clamps as min(max(x, low), high) does, so that NaN becomes `low`.
float bound(float x, float low, float high) { return x > low ? (x < high ? x : high) : low; }

float component(const Vec4 &v, Replicate replicate, std::size_t i) {
  return flush(v[replicate == Replicate::None ? i : std::size_t(replicate) - 1]);
}

class Evaluator {
public:
  Evaluator(const Shader &shader, const Inputs &inputs, const LowerOptions &options)
      : m_shader(shader), m_inputs(inputs), m_range(float(options.registerRange)) {}

  Vec4 run() {
    for (std::size_t i = 0; i < m_shader.passCount; ++i) {
      start(m_shader.passes[i]);
      for (std::size_t j = 0; j < m_shader.passes[i].pairCount; ++j)
        execute(m_shader.passes[i].pairs[j]);
    }
    return m_registers[0];
  }

private:
  void start(const Pass &pass) {
    RegisterValues started = {};
    for (std::size_t i = 0; i < pass.setups.size(); ++i) {
      const Setup &setup = pass.setups[i];
      if (setup.kind == SetupKind::None)
        continue;
      const Vec4 from =
          setup.fromRegister ? m_registers[setup.source] : m_inputs.texCoords[setup.source];
      if (setup.kind == SetupKind::PassTexCoord)
        started[i] = passed(from, setup.coordinates);
      else if (m_inputs.texture)
        started[i] = m_inputs.texture(int(i), sampled(from, setup.coordinates));
      for (float &value : started[i])
        value = inRange(flush(value));
    }
    m_registers = started;
  }

  static Vec4 passed(const Vec4 &c, Coordinates coordinates) {
    switch (coordinates) {
    case Coordinates::Str:
      return {c[0], c[1], c[2], 0.0f};
    case Coordinates::Stq:
      return {c[0], c[1], c[3], 0.0f};
    case Coordinates::StrDr:
    case Coordinates::StqDq:
      break;
    }
    const float divisor = flush(coordinates == Coordinates::StrDr ? c[2] : c[3]);
    const float inverse = flush(1.0f / divisor);
    return {flush(c[0]) * inverse, flush(c[1]) * inverse, inverse, 0.0f};
  }

  static Vec4 sampled(const Vec4 &c, Coordinates coordinates) {
    switch (coordinates) {
    case Coordinates::Str:
      return {c[0], c[1], c[2], 0.0f};
    case Coordinates::Stq:
      return {c[0], c[1], c[3], 0.0f};
    case Coordinates::StrDr:
      return {c[0] / c[2], c[1] / c[2], 1.0f / c[2], 0.0f};
    case Coordinates::StqDq:
      break;
    }
    return {c[0] / c[3], c[1] / c[3], 1.0f / c[3], 0.0f};
  }

  void execute(const Pair &pair) {
    RegisterValues after = m_registers;
    if (pair.color)
      for (std::size_t i = 0; i < 3; ++i)
        if (pair.color->mask >> i & 1)
          after[pair.color->destination][i] = finished(*pair.color, result(*pair.color, i));
    if (pair.alpha) {
      const Operation &source = isDot(pair.alpha->op) ? *pair.color : *pair.alpha;
      after[pair.alpha->destination][3] = finished(*pair.alpha, result(source, 3));
    }
    m_registers = after;
  }

  /// Returns component i of an operation's result (table 3.21).
  float result(const Operation &op, std::size_t i) const {
    const auto a = [&](std::size_t argument, std::size_t at) {
      return this->argument(op.arguments[argument], at);
    };
    const auto product = [&](std::size_t at) { return flush(a(0, at) * a(1, at)); };
    switch (op.op) {
    case Op::Mov:
      return a(0, i);
    case Op::Add:
      return flush(a(0, i) + a(1, i));
    case Op::Sub:
      return flush(a(0, i) - a(1, i));
    case Op::Mul:
      return product(i);
    case Op::Mad:
      return flush(product(i) + a(2, i));
    case Op::Lerp:
      return flush(product(i) + flush(flush(1.0f - a(0, i)) * a(2, i)));
    case Op::Cnd:
      return a(2, i) > 0.5f ? a(0, i) : a(1, i);
    case Op::Cnd0:
      return a(2, i) < 0.0f ? a(1, i) : a(0, i);
    case Op::Dot2Add:
      return flush(flush(product(0) + product(1)) + a(2, 2));
    case Op::Dot3: // same order as in ir/semantics.h
      return flush(flush(product(2) + product(1)) + product(0));
    case Op::Dot4:
      return flush(flush(flush(product(3) + product(2)) + product(1)) + product(0));
    }
    return 0.0f;
  }

  /// Applies the destination modifiers (table 3.22).
  float finished(const Operation &op, float d) const {
    switch (op.scale) {
    case Scale::None:
      break;
    case Scale::Twice:
      d = 2.0f * d;
      break;
    case Scale::Four:
      d = 4.0f * d;
      break;
    case Scale::Eight:
      d = 8.0f * d;
      break;
    case Scale::Half:
      d = d / 2.0f;
      break;
    case Scale::Quarter:
      d = d / 4.0f;
      break;
    case Scale::Eighth:
      d = d / 8.0f;
      break;
    }
    return op.saturate ? bound(flush(d), 0.0f, 1.0f) : inRange(flush(d));
  }

  float inRange(float x) const { return m_range == 0.0f ? x : bound(x, -m_range, m_range); }

  /// Returns a component of an argument after its modifiers (tables 3.23 and 3.24).
  float argument(const Argument &argument, std::size_t i) const {
    float s = component(source(argument), argument.replicate, i);
    if (argument.complement)
      s = flush(1.0f - s);
    if (argument.bias)
      s = flush(s - 0.5f);
    if (argument.twice)
      s = 2.0f * s;
    return argument.negate ? -s : s;
  }

  Vec4 source(const Argument &argument) const {
    switch (argument.source) {
    case Source::Register:
      return m_registers[argument.index];
    case Source::Constant:
      return constant(m_shader.constants[argument.index]);
    case Source::Zero:
      return {0.0f, 0.0f, 0.0f, 0.0f};
    case Source::One:
      return {1.0f, 1.0f, 1.0f, 1.0f};
    case Source::Primary:
      return m_inputs.primary;
    case Source::Secondary:
      break;
    }
    return m_inputs.secondary;
  }

  Vec4 constant(const Constant &constant) const {
    Vec4 value = {};
    if (constant.kind == ConstantKind::Value)
      value = constant.value;
    else if (m_inputs.constant)
      value = m_inputs.constant(constant);
    for (float &c : value)
      c = bound(c, 0.0f, 1.0f);
    return value;
  }

  const Shader &m_shader;
  const Inputs &m_inputs;
  float m_range;
  RegisterValues m_registers = {};
};

} // namespace

ir::Vec4 evaluate(const Shader &shader, const Inputs &inputs, const LowerOptions &options) {
  return Evaluator(shader, inputs, options).run();
}

} // namespace arbiter::fp::ati
