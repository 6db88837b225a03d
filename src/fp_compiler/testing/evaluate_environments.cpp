#include "fp_compiler/testing/evaluate_environments.h"

#include <algorithm>

namespace arbiter::fp::texture_shader {

namespace {

double positive(double value) { return std::max(0.0, value); }
double mix(double weight, double constant, double fragment) {
  return fragment * (1.0 - positive(weight)) + constant * positive(weight);
}
double added(double a, double b) { return std::max(-1.0, std::min(1.0, a + b)); }

struct Unit {
  Color fragment, texel, constant;
};

/// Computes tables 3.18 and 3.19 as amended, a column for each base.
Color conventional(EnvironmentMode mode, Base base, const Unit &u) {
  const Color &f = u.fragment, &t = u.texel, &c = u.constant;
  const bool rgb = base != Base::Alpha, opaque = base == Base::Luminance || base == Base::Rgb;
  const bool intensity = base == Base::Intensity || base == Base::DsdtMagIntensity;
  Color v = f;
  for (std::size_t i = 0; i < 3 && rgb; ++i)
    switch (mode) {
    case EnvironmentMode::Replace:
      v[i] = t[i];
      break;
    case EnvironmentMode::Modulate:
      v[i] = f[i] * t[i];
      break;
    case EnvironmentMode::Decal:
      v[i] = base == Base::Rgb ? t[i] : base == Base::Rgba ? mix(t[3], t[i], f[i]) : f[i];
      break;
    case EnvironmentMode::Blend:
      v[i] = mix(t[i], c[i], f[i]);
      break;
    case EnvironmentMode::Add:
      v[i] = added(f[i], t[i]);
      break;
    default:
      break;
    }
  if (opaque || mode == EnvironmentMode::Decal)
    return v;
  if (mode == EnvironmentMode::Replace)
    v[3] = t[3];
  else if (intensity && mode == EnvironmentMode::Blend)
    v[3] = mix(t[3], c[3], f[3]);
  else if (intensity && mode == EnvironmentMode::Add)
    v[3] = added(f[3], t[3]);
  else
    v[3] = f[3] * t[3];
  return v;
}

/// Returns a COMBINE function of one component of four arguments; DOT3 uses whole arguments.
double combined(const CombineHalf &half, const std::array<Color, 4> &a, std::size_t i) {
  const auto x = [&](int n) { return a[std::size_t(n)][i]; };
  const auto dot = [&] {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
      sum += (a[0][c] - 0.5) * (a[1][c] - 0.5);
    return 4.0 * sum;
  };
  switch (half.function) {
  case CombineFunction::Replace:
    return x(0);
  case CombineFunction::Modulate:
    return x(0) * x(1);
  case CombineFunction::Add:
    return x(0) + x(1);
  case CombineFunction::AddSigned:
    return x(0) + x(1) - 0.5;
  case CombineFunction::Interpolate:
    return x(0) * x(2) + x(1) * (1.0 - x(2));
  case CombineFunction::Subtract:
    return x(0) - x(1);
  case CombineFunction::Dot3Rgb:
  case CombineFunction::Dot3Rgba:
    return dot();
  case CombineFunction::ModulateAdd:
    return x(0) * x(2) + x(1);
  case CombineFunction::ModulateSignedAdd:
    return x(0) * x(2) + x(1) - 0.5;
  case CombineFunction::ModulateSubtract:
    return x(0) * x(2) - x(1);
  case CombineFunction::AddProducts:
    return x(0) * x(1) + x(2) * x(3);
  case CombineFunction::AddSignedProducts:
    return x(0) * x(1) + x(2) * x(3) - 0.5;
  case CombineFunction::BumpEnvmap:
    break; // has no arguments
  }
  return 0.0;
}

} // namespace

Color evaluateEnvironments(const Environments &environments, const std::array<Base, kUnits> &bases,
                           const std::array<Color, kUnits> &texels,
                           const std::array<Color, kUnits> &constants, const Color &primary) {
  Color color = primary;
  for (std::size_t unit = 0; unit < environments.size(); ++unit) {
    const Environment &environment = environments[unit];
    if (bases[unit] == Base::None || environment.mode == EnvironmentMode::None)
      continue;
    if (environment.mode != EnvironmentMode::Combine) {
      color = conventional(environment.mode, bases[unit], {color, texels[unit], constants[unit]});
      continue;
    }
    const auto argument = [&](const CombineArgument &named) {
      Color value{};
      if (named.source >= CombineSource::Unit0)
        value = texels[std::size_t(named.source) - std::size_t(CombineSource::Unit0)];
      else if (named.source == CombineSource::Texture)
        value = texels[unit];
      else if (named.source == CombineSource::Constant)
        value = constants[unit];
      else if (named.source == CombineSource::Primary)
        value = primary;
      else if (named.source == CombineSource::Previous)
        value = color;
      else
        value.fill(named.source == CombineSource::One ? 1.0 : 0.0);
      if (named.alpha)
        value.fill(value[3]);
      for (double &component : value)
        component = named.complement ? 1.0 - positive(component) : positive(component);
      return value;
    };
    Color next = color;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool ofColor = i < 3 || environment.color.function == CombineFunction::Dot3Rgba;
      const CombineHalf &half = ofColor ? environment.color : environment.alpha;
      std::array<Color, 4> arguments;
      for (std::size_t n = 0; n < 4; ++n)
        arguments[n] = argument(half.arguments[n]);
      next[i] = std::clamp(combined(half, arguments, i) * half.scale, 0.0, 1.0);
    }
    color = next;
  }
  return color;
}

} // namespace arbiter::fp::texture_shader
