#include "fp_compiler/testing/evaluate_combiners_fx9.h"

#include <algorithm>
#include <cmath>

namespace arbiter::fp::combiners {

namespace {

constexpr long kOne = 255;
constexpr long kHalf = 128; ///< 127.5, rounded

using Integers = std::array<long, 4>;
using RegisterSet = std::array<Integers, kRegisters + 2>; // two pseudo-registers follow

/// Returns numerator / denominator rounded to the nearest integer, halves upward.
/// Requires: denominator > 0.
long nearest(long numerator, long denominator) {
  const long doubled = 2 * numerator + denominator, by = 2 * denominator;
  const long quotient = doubled / by;
  return doubled % by < 0 ? quotient - 1 : quotient;
}

/// Applies a mapping of table RC.4.
long mapped(long e, Mapping mapping) {
  const long positive = std::max(0L, e);
  switch (mapping) {
  case Mapping::UnsignedIdentity:
    return positive;
  case Mapping::UnsignedInvert:
    return kOne - std::min(positive, kOne);
  case Mapping::ExpandNormal:
    return 2 * positive - kOne;
  case Mapping::ExpandNegate:
    return kOne - 2 * positive;
  case Mapping::HalfBiasNormal:
    return positive - kHalf;
  case Mapping::HalfBiasNegate:
    return kHalf - positive;
  case Mapping::SignedIdentity:
    return e;
  case Mapping::SignedNegate:
    return -e;
  }
  return e;
}

Integers assigned(const Input &input, const RegisterSet &set) {
  const Integers &from = set[std::size_t(input.source)];
  Integers value = from;
  if (input.usage != Usage::Rgb)
    value.fill(from[input.usage == Usage::Alpha ? 3 : 2]);
  for (long &e : value)
    e = mapped(e, input.mapping);
  return value;
}

/// Returns a product or a dot product in units of 1/(255 * 255).
Integers product(const Integers &left, const Integers &right, bool dot) {
  Integers result{};
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = left[c] * right[c];
  if (dot)
    result.fill(result[0] + result[1] + result[2]);
  return result;
}

class Fx9Combiners {
public:
  Fx9Combiners(const State &state, const Inputs &inputs) : m_state(state), m_inputs(inputs) {
    const auto at = [&](Register name) -> Integers & { return m_set[std::size_t(name)]; };
    at(Register::Primary) = held(inputs.primary);
    at(Register::Secondary) = held(inputs.secondary);
    for (int unit = 0; unit < kTextures; ++unit)
      at(textureRegister(unit)) = held(inputs.textures[std::size_t(unit)]);
    at(Register::Spare0)[3] = at(textureRegister(0))[3];
    const Color &fog = inputs.fog;
    at(Register::Fog) = held({fog[0], fog[1], fog[2], inputs.fogFactor});
  }

  Evaluated run() {
    for (int i = 0; i < m_state.count; ++i)
      general(i);
    setConstants(globalConstant(0), globalConstant(1));
    const Integers result = final();
    for (std::size_t c = 0; c < 4; ++c)
      m_result.color[c] = double(result[c]) / kOne;
    return m_result;
  }

private:
  Integers held(const Color &given) {
    Integers result{};
    for (std::size_t c = 0; c < 4; ++c) {
      const double steps = std::clamp(given[c], -1.0, 1.0) * kOne;
      result[c] = std::lround(std::floor(steps + 0.5));
      m_result.margin = std::min(m_result.margin, 0.5 - std::abs(steps - double(result[c])));
    }
    return result;
  }

  void setConstants(int zero, int one) {
    m_set[std::size_t(Register::Constant0)] = held(m_inputs.constants[std::size_t(zero)]);
    m_set[std::size_t(Register::Constant1)] = held(m_inputs.constants[std::size_t(one)]);
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
    std::array<Integers, 4> variables;
    for (std::size_t v = 0; v < variables.size(); ++v)
      variables[v] = assigned(portion.inputs[v], m_set);
    const Integers ab = product(variables[0], variables[1], portion.abDot);
    const Integers cd = product(variables[2], variables[3], portion.cdDot);
    const bool below = m_set[std::size_t(Register::Spare0)][3] < kHalf;
    const auto term = [](long e, bool dot) {
      return dot ? std::clamp(e, -kOne * kOne, kOne * kOne) : e;
    };
    Integers sum{};
    for (std::size_t c = 0; c < 4; ++c) {
      const long left = term(ab[c], portion.abDot), right = term(cd[c], portion.cdDot);
      sum[c] = !portion.mux ? left + right : below ? left : right;
    }
    const auto write = [&](Register to, const Integers &computed) {
      if (to == Register::Discard)
        return;
      constexpr long kScaleOfTwo[] = {2, 4, 8, 1};
      const long bias = portion.bias ? kHalf * kOne : 0;
      for (std::size_t c = first; c < end; ++c)
        next[std::size_t(to)][c] = std::clamp(
            nearest((computed[c] - bias) * kScaleOfTwo[std::size_t(portion.scale)], 2 * kOne),
            -kOne, kOne);
    };
    write(portion.ab, ab);
    write(portion.cd, cd);
    write(portion.sum, sum);
  }

  Integers final() {
    const auto variable = [&](std::size_t v) { return assigned(m_state.finals[v], m_set); };
    Integers &product = m_set[std::size_t(Register::ETimesF)];
    Integers &sum = m_set[std::size_t(Register::Spare0PlusSecondary)];
    const Integers e = variable(4), f = variable(5);
    for (std::size_t c = 0; c < 3; ++c) {
      product[c] = nearest(e[c] * f[c], kOne);
      sum[c] = std::max(0L, m_set[std::size_t(Register::Spare0)][c]) +
               std::max(0L, m_set[std::size_t(Register::Secondary)][c]);
      if (m_state.sumClamp)
        sum[c] = std::min(sum[c], kOne);
    }
    const Integers va = variable(0), vb = variable(1), vc = variable(2), vd = variable(3);
    Integers result{};
    for (std::size_t c = 0; c < 3; ++c)
      result[c] =
          std::min(nearest(va[c] * vb[c] + (kOne - va[c]) * vc[c] + kOne * vd[c], kOne), kOne);
    result[3] = variable(6)[3];
    return result;
  }

  const State &m_state;
  const Inputs &m_inputs;
  RegisterSet m_set{};
  Evaluated m_result;
};

} // namespace

Evaluated evaluateFx9(const State &state, const Inputs &inputs) {
  return Fx9Combiners(state, inputs).run();
}

} // namespace arbiter::fp::combiners
