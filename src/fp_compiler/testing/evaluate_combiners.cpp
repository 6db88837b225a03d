#include "fp_compiler/testing/evaluate_combiners.h"

#include <algorithm>
#include <cmath>

namespace arbiter::fp::combiners {

namespace {

using RegisterSet = std::array<Color, kRegisters + 2>; // two pseudo-registers follow

/// Applies a mapping of table RC.4.
double mapped(double e, Mapping mapping) {
  switch (mapping) {
  case Mapping::UnsignedIdentity:
    return std::max(0.0, e);
  case Mapping::UnsignedInvert:
    return 1.0 - std::min(std::max(e, 0.0), 1.0);
  case Mapping::ExpandNormal:
    return 2.0 * std::max(0.0, e) - 1.0;
  case Mapping::ExpandNegate:
    return -2.0 * std::max(0.0, e) + 1.0;
  case Mapping::HalfBiasNormal:
    return std::max(0.0, e) - 0.5;
  case Mapping::HalfBiasNegate:
    return -std::max(0.0, e) + 0.5;
  case Mapping::SignedIdentity:
    return e;
  case Mapping::SignedNegate:
    return -e;
  }
  return e;
}

/// Returns the variable in components r, g, b and a. Each portion reads its own.
Color assigned(const Input &input, const RegisterSet &set) {
  const Color &from = set[std::size_t(input.source)];
  Color value = from;
  if (input.usage == Usage::Alpha)
    value.fill(from[3]);
  else if (input.usage == Usage::Blue)
    value.fill(from[2]);
  for (double &e : value)
    e = mapped(e, input.mapping);
  return value;
}

/// Returns a product or a dot product. The alpha portion uses component a.
Color product(const Color &left, const Color &right, bool dot) {
  Color result{};
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = left[c] * right[c];
  if (dot)
    result.fill(result[0] + result[1] + result[2]);
  return result;
}

class Combiners {
public:
  Combiners(const State &state, const Inputs &inputs) : m_state(state), m_inputs(inputs) {
    const auto at = [&](Register name) -> Color & { return m_set[std::size_t(name)]; };
    at(Register::Primary) = inputs.primary;
    at(Register::Secondary) = inputs.secondary;
    for (int unit = 0; unit < kTextures; ++unit)
      at(textureRegister(unit)) = inputs.textures[std::size_t(unit)];
    at(Register::Spare0)[3] = inputs.textures[0][3];
    at(Register::Fog) = inputs.fog;
    at(Register::Fog)[3] = inputs.fogFactor;
  }

  Evaluated run() {
    for (int i = 0; i < m_state.count; ++i)
      general(i);
    setConstants(globalConstant(0), globalConstant(1));
    m_result.color = final();
    return m_result;
  }

private:
  void setConstants(int zero, int one) {
    m_set[std::size_t(Register::Constant0)] = m_inputs.constants[std::size_t(zero)];
    m_set[std::size_t(Register::Constant1)] = m_inputs.constants[std::size_t(one)];
  }

  void general(int i) {
    const bool own = m_state.perStageConstants;
    setConstants(own ? stageConstant(i, 0) : globalConstant(0),
                 own ? stageConstant(i, 1) : globalConstant(1));
    const Stage &stage = m_state.stages[std::size_t(i)];
    RegisterSet next = m_set;
    portion(stage.rgb, 0, 3, next);
    portion(stage.alpha, 3, 4, next);
    m_set = next;
  }

  /// Computes components [first, end) of the outputs.
  void portion(const Portion &portion, std::size_t first, std::size_t end, RegisterSet &next) {
    std::array<Color, 4> variables;
    for (std::size_t v = 0; v < variables.size(); ++v)
      variables[v] = assigned(portion.inputs[v], m_set);
    const Color ab = product(variables[0], variables[1], portion.abDot);
    const Color cd = product(variables[2], variables[3], portion.cdDot);
    Color sum{};
    const double chooser = m_set[std::size_t(Register::Spare0)][3];
    // A dot product in a sum is clamped to the range of a register.
    const auto term = [](double e, bool dot) { return dot ? std::clamp(e, -1.0, 1.0) : e; };
    for (std::size_t c = 0; c < 4; ++c) {
      const double left = term(ab[c], portion.abDot), right = term(cd[c], portion.cdDot);
      sum[c] = !portion.mux ? left + right : chooser < 0.5 ? left : right;
    }
    if (portion.mux && portion.sum != Register::Discard)
      m_result.margin = std::min(m_result.margin, std::abs(chooser - 0.5));
    const auto write = [&](Register to, const Color &computed) {
      if (to == Register::Discard)
        return;
      constexpr double kScales[] = {1.0, 2.0, 4.0, 0.5};
      const double bias = portion.bias ? -0.5 : 0.0;
      for (std::size_t c = first; c < end; ++c)
        next[std::size_t(to)][c] = std::max(
            std::min((computed[c] + bias) * kScales[std::size_t(portion.scale)], 1.0), -1.0);
    };
    write(portion.ab, ab);
    write(portion.cd, cd);
    write(portion.sum, sum);
  }

  Color final() {
    const auto variable = [&](std::size_t v) { return assigned(m_state.finals[v], m_set); };
    Color &product = m_set[std::size_t(Register::ETimesF)];
    Color &sum = m_set[std::size_t(Register::Spare0PlusSecondary)];
    const Color e = variable(4), f = variable(5);
    for (std::size_t c = 0; c < 3; ++c) {
      product[c] = e[c] * f[c];
      sum[c] = mapped(m_set[std::size_t(Register::Spare0)][c], Mapping::UnsignedIdentity) +
               mapped(m_set[std::size_t(Register::Secondary)][c], Mapping::UnsignedIdentity);
      if (m_state.sumClamp)
        sum[c] = std::clamp(sum[c], 0.0, 1.0);
    }
    const Color va = variable(0), vb = variable(1), vc = variable(2), vd = variable(3);
    Color result{};
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = std::min(va[c] * vb[c] + (1.0 - va[c]) * vc[c] + vd[c], 1.0);
    result[3] = variable(6)[3];
    return result;
  }

  const State &m_state;
  const Inputs &m_inputs;
  RegisterSet m_set{};
  Evaluated m_result;
};

} // namespace

Evaluated evaluate(const State &state, const Inputs &inputs) {
  return Combiners(state, inputs).run();
}

} // namespace arbiter::fp::combiners
