#include "fp_compiler/testing/vertex_shader/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arbiter::fp::testing {

namespace {

using namespace vertex_shader;

class Evaluation {
public:
  Evaluation(const Shader &shader, std::vector<SymbolValue> values, double disturbance)
      : m_shader(shader), m_values(std::move(values)), m_disturbance(disturbance) {}

  VertexShaderResults run() {
    for (const Operation &operation : m_shader.code)
      execute(operation);
    return m_results;
  }

private:
  /// Returns where a result is stored, with as many numbers as its type has.
  double *placeOf(const Result &result) {
    switch (result.place) {
    case Place::Position:
      return m_results.position.data();
    case Place::Color:
      return m_results.colors[result.index].data();
    case Place::TexCoord:
      return m_results.texCoords[result.index].data();
    case Place::Fog:
      return &m_results.fog;
    case Place::Local:
      break;
    }
    return m_values[result.index].data();
  }

  double disturbed(double value) {
    m_up = !m_up;
    return value * (m_up ? 1.0 + m_disturbance : 1.0 - m_disturbance);
  }

  /// Returns component `i` of an argument. A scalar has the same value for all.
  double a(const Operation &operation, std::size_t at, std::size_t i) const {
    const std::uint32_t symbol = operation.arguments[at];
    return m_values[symbol][m_shader.symbols[symbol].type == DataType::Scalar ? 0 : i];
  }

  /// Returns component i of an operation that works on each component alone.
  double component(const Operation &o, std::size_t i) const {
    switch (o.op) {
    case Op::Negate:
      return -a(o, 0, i);
    case Op::Mul:
      return a(o, 0, i) * a(o, 1, i);
    case Op::Add:
      return a(o, 0, i) + a(o, 1, i);
    case Op::Sub:
      return a(o, 0, i) - a(o, 1, i);
    case Op::Madd:
      return a(o, 0, i) * a(o, 1, i) + a(o, 2, i);
    case Op::Frac:
      return a(o, 0, i) - std::floor(a(o, 0, i));
    case Op::Max:
      return std::max(a(o, 0, i), a(o, 1, i));
    case Op::Min:
      return std::min(a(o, 0, i), a(o, 1, i));
    case Op::SetGe:
      return a(o, 0, i) >= a(o, 1, i) ? 1.0 : 0.0;
    case Op::SetLt:
      return a(o, 0, i) < a(o, 1, i) ? 1.0 : 0.0;
    case Op::Clamp:
      return a(o, 0, i) <= a(o, 1, i)   ? a(o, 1, i)
             : a(o, 0, i) >= a(o, 2, i) ? a(o, 2, i)
                                        : a(o, 0, i);
    case Op::Floor:
      return std::floor(a(o, 0, i));
    case Op::Round:
      return std::floor(a(o, 0, i) + 0.5);
    case Op::ExpBase2:
      return std::exp2(a(o, 0, i));
    case Op::LogBase2:
      return a(o, 0, i) == 0.0 ? -std::numeric_limits<double>::infinity() : std::log2(a(o, 0, i));
    case Op::Power:
      return std::pow(a(o, 0, i), a(o, 1, i));
    case Op::Recip:
      return a(o, 0, i) == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / a(o, 0, i);
    case Op::RecipSqrt:
      return a(o, 0, i) == 0.0 ? std::numeric_limits<double>::infinity()
                               : 1.0 / std::sqrt(a(o, 0, i));
    default:
      return a(o, 0, i);
    }
  }

  double dot(const Operation &o, std::size_t components) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < components; ++i)
      sum += a(o, 0, i) * a(o, 1, i);
    return sum;
  }

  double taken(const Operation &o, Take take) const {
    switch (take) {
    case Take::Zero:
      return 0.0;
    case Take::One:
      return 1.0;
    case Take::NegOne:
      return -1.0;
    default:
      break;
    }
    return take < Take::NegX ? a(o, 0, std::size_t(take))
                             : -a(o, 0, std::size_t(take) - std::size_t(Take::NegX));
  }

  /// Returns the value of a symbol in the second argument's block. The first argument is the
  /// distance.
  const SymbolValue &indexed(const Operation &o) const {
    return m_values[o.arguments[1] + std::size_t(std::int64_t(m_values[o.arguments[0]][0]))];
  }

  void execute(const Operation &o) {
    double *const r = placeOf(o.result);
    const DataType type = typeOf(o.result, m_shader.symbols);
    const std::size_t count = type == DataType::Scalar ? 1 : type == DataType::Vector ? 4 : 16;
    SymbolValue value{};
    std::copy_n(r, count, value.begin());
    switch (o.op) {
    case Op::Index:
      value = indexed(o);
      break;
    case Op::Dot3:
      std::fill_n(value.begin(), std::min<std::size_t>(count, 3), disturbed(dot(o, 3)));
      break;
    case Op::Dot4:
      std::fill_n(value.begin(), count, disturbed(dot(o, 4)));
      break;
    case Op::CrossProduct:
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        value[i] = disturbed(a(o, 0, j) * a(o, 1, k) - a(o, 1, j) * a(o, 0, k));
      }
      value[3] = 1.0;
      break;
    case Op::MultiplyMatrix:
      for (std::size_t i = 0; i < 4; ++i)
        value[i] = disturbed(a(o, 1, 0) * a(o, 0, i) + a(o, 1, 1) * a(o, 0, 4 + i) +
                             a(o, 1, 2) * a(o, 0, 8 + i) + a(o, 1, 3) * a(o, 0, 12 + i));
      break;
    case Op::Swizzle:
      for (std::size_t i = 0; i < 4; ++i)
        value[i] = taken(o, o.takes[i]);
      break;
    case Op::WriteMask:
      for (std::size_t i = 0; i < 4; ++i)
        if ((o.mask >> i & 1u) != 0)
          value[i] = a(o, 0, i);
      break;
    case Op::InsertComponent:
      if (type == DataType::Vector)
        value[o.component] = a(o, 0, 0);
      else
        for (std::size_t i = 0; i < 4; ++i)
          value[o.component + 4 * i] = a(o, 0, i);
      break;
    case Op::ExtractComponent:
      if (type == DataType::Scalar)
        value[0] = a(o, 0, o.component);
      else
        for (std::size_t i = 0; i < 4; ++i)
          value[i] = a(o, 0, o.component + 4 * i);
      break;
    default:
      for (std::size_t i = 0; i < count; ++i)
        value[i] = disturbed(component(o, i));
    }
    std::copy_n(value.begin(), count, r);
    m_results.defined = m_results.defined && std::all_of(r, r + count, [](double each) {
                          return std::abs(each) < kMax; // false for a NaN
                        });
  }

  static constexpr double kMax = 1e9; ///< a limit well inside the range of single precision

  const Shader &m_shader;
  std::vector<SymbolValue> m_values;
  double m_disturbance;
  bool m_up = false;
  VertexShaderResults m_results;
};

} // namespace

VertexShaderResults evaluateVertexShader(const Shader &shader, std::vector<SymbolValue> values,
                                         double disturbance) {
  return Evaluation(shader, std::move(values), disturbance).run();
}

} // namespace arbiter::fp::testing
