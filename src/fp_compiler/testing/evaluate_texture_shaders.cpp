#include "fp_compiler/testing/evaluate_texture_shaders.h"

#include <algorithm>
#include <cmath>

#include "fp_compiler/testing/texture_shader_rules.h"

namespace arbiter::fp::texture_shader {

namespace {

using Type = ResultType;

class Fragment {
public:
  Fragment(const State &state, const Inputs &inputs) : m_state(state), m_inputs(inputs) {}

  Evaluated run() {
    for (int i = 0; i < m_state.units; ++i)
      m_out.consistent[std::size_t(i)] = isConsistent(m_state, i);
    for (int i = 0; i < m_state.units; ++i)
      if (m_out.consistent[std::size_t(i)])
        stage(i);
    return m_out;
  }

private:
  using O = Operation;
  [[nodiscard]] O operation(int i) const {
    return i >= 0 && i < m_state.units ? m_state.stages[std::size_t(i)].operation : O::None;
  }
  [[nodiscard]] int previousOf(int i) const { return m_state.stages[std::size_t(i)].previous; }

  void noteMargin(double margin) { m_out.margin = std::min(m_out.margin, margin); }

  /// Samples a texture, and sets both results of the stage.
  void access(int i, double s, double t, double r, double scale = 1.0) {
    const Sampled sampled = m_inputs.sample(i, {s, t, r});
    noteMargin(sampled.margin);
    Result &result = m_results[std::size_t(i)];
    result = kindOfResult(m_state, i);
    result.value = sampled.texel;
    Color &color = m_out.colors[std::size_t(i)];
    if (result.type == Type::Colors) {
      if (result.base == Base::Alpha && !m_state.conventional)
        result.value = {1, 1, 1, sampled.texel[3]};
      color = result.value;
      for (std::size_t c = 0; c < 3; ++c)
        color[c] *= scale;
      m_out.environment[std::size_t(i)] = result.base;
    } else if (result.base == Base::DsdtMagIntensity) {
      color.fill(sampled.texel[3]);
      m_out.environment[std::size_t(i)] = result.base;
    }
  }

  void color(int i, const Color &value) {
    m_results[std::size_t(i)] = {Type::Colors, Base::Rgba, Signs::Unsigned, value};
    m_out.colors[std::size_t(i)] = value;
    m_out.environment[std::size_t(i)] = Base::Rgba;
  }

  void offset(int i, bool projective, bool scales) {
    const Color &c = m_inputs.coordinates[std::size_t(i)];
    const Result &previous = m_results[std::size_t(previousOf(i))];
    const auto &a = m_inputs.matrices[std::size_t(i)];
    const double first = previous.value[0], second = previous.value[1];
    const double q = projective ? c[3] : 1.0;
    const double scale =
        std::max(0.0, std::min(1.0, m_inputs.biases[std::size_t(i)] +
                                        m_inputs.scales[std::size_t(i)] * previous.value[2]));
    access(i, c[0] / q + a[0] * first + a[2] * second, c[1] / q + a[1] * first + a[3] * second, 0.0,
           scales ? scale : 1.0);
  }

  [[nodiscard]] double dot(int i) const {
    const Color &c = m_inputs.coordinates[std::size_t(i)];
    const Result &p = m_results[std::size_t(previousOf(i))];
    const Color &v = p.value;
    if (p.type == Type::Hilo && p.signs == Signs::Unsigned)
      return c[0] * v[0] + c[1] * v[1] + c[2];
    if (p.type == Type::Hilo)
      return c[0] * v[0] + c[1] * v[1] +
             c[2] * std::sqrt(std::max(0.0, 1.0 - v[0] * v[0] - v[1] * v[1]));
    if (p.signs == Signs::Unsigned) {
      switch (m_state.stages[std::size_t(i)].mapping) {
      case Mapping::ExpandNormal:
        return c[0] * (2.0 * v[0] - 1.0) + c[1] * (2.0 * v[1] - 1.0) + c[2] * (2.0 * v[2] - 1.0);
      case Mapping::ForceBlueToOne:
        return c[0] * v[0] + c[1] * v[1] + c[2];
      default:
        break;
      }
    }
    return c[0] * v[0] + c[1] * v[1] + c[2] * v[2];
  }

  void reflect(int i) {
    const std::array<double, 3> n = {dot(i - 2), dot(i - 1), dot(i)};
    std::array<double, 3> e = m_inputs.eyes[std::size_t(i)];
    if (operation(i) == O::DotProductReflectCubeMap)
      for (int k = 0; k < 3; ++k)
        e[std::size_t(k)] = m_inputs.coordinates[std::size_t(i - 2 + k)][3];
    const double nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const double ne = n[0] * e[0] + n[1] * e[1] + n[2] * e[2];
    noteMargin(nn / 20.0);
    const double factor = nn != 0.0 ? 2.0 * ne / nn : 0.0;
    access(i, factor * n[0] - e[0], factor * n[1] - e[1], factor * n[2] - e[2]);
  }

  void depth(double value, double denominator) {
    m_out.replacesDepth = true;
    m_out.depth = value;
    const double low = std::min(m_inputs.near, m_inputs.far),
                 high = std::max(m_inputs.near, m_inputs.far);
    m_out.depthOutOfRange = value < low || value > high;
    m_out.discarded = m_out.discarded || m_out.depthOutOfRange;
    noteMargin(std::min(std::abs(value - low), std::abs(value - high)));
    noteMargin(std::abs(denominator) / 20.0);
  }

  void cull(int i) {
    for (int c = 0; c < 4; ++c) {
      const double value = m_inputs.coordinates[std::size_t(i)][std::size_t(c)];
      const bool less = (m_state.stages[std::size_t(i)].cullLess >> c & 1) != 0;
      m_out.discarded = m_out.discarded || (less ? !(value < 0.0) : !(value >= 0.0));
    }
  }

  void stage(int i) {
    const Color &c = m_inputs.coordinates[std::size_t(i)];
    const auto unit = [](double v) { return std::max(0.0, std::min(1.0, v)); };
    const Color &p = m_results[std::size_t(previousOf(i))].value;
    switch (operation(i)) {
    case O::None:
    case O::DotProduct:
      return;
    case O::Texture1D:
      return access(i, c[0] / c[3], 0.0, c[2] / c[3]);
    case O::Texture2D:
    case O::TextureRectangle:
    case O::Texture3D:
      return access(i, c[0] / c[3], c[1] / c[3], c[2] / c[3]);
    case O::TextureCubeMap:
      return access(i, c[0], c[1], c[2]);
    case O::PassThrough:
      return color(i, {unit(c[0]), unit(c[1]), unit(c[2]), unit(c[3])});
    case O::CullFragment:
      return cull(i);
    case O::Offset2D:
    case O::OffsetRectangle:
    case O::OffsetHilo2D:
    case O::OffsetHiloRectangle:
      return offset(i, false, false);
    case O::Offset2DScale:
    case O::OffsetRectangleScale:
      return offset(i, false, true);
    case O::OffsetProjective2D:
    case O::OffsetProjectiveRectangle:
    case O::OffsetHiloProjective2D:
    case O::OffsetHiloProjectiveRectangle:
      return offset(i, true, false);
    case O::OffsetProjective2DScale:
    case O::OffsetProjectiveRectangleScale:
      return offset(i, true, true);
    case O::DependentAR2D:
      return access(i, p[3], p[0], 0.0);
    case O::DependentGB2D:
      return access(i, p[1], p[2], 0.0);
    case O::DependentHilo2D:
      return access(i, p[0], p[1], 0.0);
    case O::DependentRgb3D:
      return access(i, p[0], p[1], p[2]);
    case O::DependentRgbCubeMap:
      if (m_results[std::size_t(previousOf(i))].signs == Signs::Unsigned)
        return access(i, 2.0 * (p[0] - 0.5), 2.0 * (p[1] - 0.5), 2.0 * (p[2] - 0.5));
      return access(i, p[0], p[1], p[2]);
    case O::DotProduct1D:
      return access(i, dot(i), 0.0, 0.0);
    case O::DotProduct2D:
    case O::DotProductRectangle:
      return access(i, dot(i - 1), dot(i), 0.0);
    case O::DotProduct3D:
    case O::DotProductCubeMap:
      return access(i, dot(i - 2), dot(i - 1), dot(i));
    case O::DotProductReflectCubeMap:
    case O::DotProductConstEyeReflectCubeMap:
      return reflect(i);
    case O::DotProductDiffuseCubeMap:
      return access(i, dot(i - 1), dot(i), dot(i + 1));
    case O::DotProductPassThrough: {
      const double x = unit(dot(i));
      return color(i, {x, x, x, x});
    }
    case O::DotProductDepthReplace:
      return depth(dot(i - 1) / dot(i), dot(i));
    case O::DotProductAffineDepthReplace:
      return depth(dot(i), 1.0);
    }
  }

  const State &m_state;
  const Inputs &m_inputs;
  std::array<Result, kUnits> m_results{};
  Evaluated m_out;
};

} // namespace

Evaluated evaluate(const State &state, const Inputs &inputs) {
  return Fragment(state, inputs).run();
}

Color registerOf(const Evaluated &evaluated, int unit) {
  const Color &color = evaluated.colors[std::size_t(unit)];
  const Base base = evaluated.environment[std::size_t(unit)];
  if (base == Base::Alpha || base == Base::DsdtMagIntensity)
    return {0, 0, 0, color[3]};
  return color;
}

} // namespace arbiter::fp::texture_shader
