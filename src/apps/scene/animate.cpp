#include "apps/scene/animate.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace arbiter::scene {

namespace {

constexpr double kPeriod = 2 * std::numbers::pi; ///< of a sine wave

double fraction(double x) { return x - std::floor(x); }

/// Returns 0 to 1 and back to 0 for x from 0 to 1.
double foldedUp(double x) { return 1 - std::abs(1 - 2 * fraction(x)); }

double within(AnimationKind kind, double begin, double periods) {
  switch (kind) {
  case AnimationKind::Sine:
    return 0.5 + 0.5 * std::sin(std::asin(2 * begin - 1) + kPeriod * periods);
  case AnimationKind::Saw:
    return begin + periods == 1 ? 1 : fraction(begin + periods);
  case AnimationKind::Triangle:
    return foldedUp(0.5 * begin + periods);
  case AnimationKind::Time:
  case AnimationKind::Turn:
    break;
  }
  return begin;
}

/// Rotates x and z about the y axis.
void turn(const Parameter &parameter, double seconds, std::array<double, 4> &value) {
  const double angle = kPeriod * seconds / parameter.animation->period.value;
  const double x = value[0], z = value[2];
  value[0] = x * std::cos(angle) + z * std::sin(angle);
  value[2] = z * std::cos(angle) - x * std::sin(angle);
}

glm::mat4 rotationAt(const Parameter &parameter, double seconds) {
  const WordRow &row = rowOf(ValueKind::Rotate);
  const auto get = [&](const char *name) { return float(parameter.arguments.get(row, name)); };
  const auto degrees = float(animated(parameter.values[0].value, parameter, seconds));
  const glm::vec3 place(get("px"), get("py"), get("pz"));
  const glm::mat4 there = glm::translate(glm::mat4(1.0f), place);
  return glm::translate(
      glm::rotate(there, glm::radians(degrees), glm::vec3(get("x"), get("y"), get("z"))), -place);
}

class Rows {
public:
  explicit Rows(const Surroundings &surroundings) : m_surroundings(surroundings) {}

  void add(const Parameter &parameter, double seconds) {
    switch (parameter.kind.value) {
    case ValueKind::Numbers: {
      const auto value = valueAt(parameter, seconds);
      for (std::size_t i = 0; i < 4; ++i)
        if (parameter.mask[i])
          row(parameter, 0).value[i] = float(value[i]);
      break;
    }
    case ValueKind::Rotate:
      addMatrix(parameter, rotationAt(parameter, seconds));
      break;
    case ValueKind::Camera:
      if (const auto view = m_surroundings.viewOfTarget(parameter.target.text))
        addMatrix(parameter, toTexture(*view));
      break;
    case ValueKind::Eye: {
      const glm::vec3 eye = m_surroundings.view.eye;
      row(parameter, 0).value = {eye.x, eye.y, eye.z, 1};
      break;
    }
    }
  }

  std::vector<ParameterRow> take() { return std::move(m_rows); }

private:
  ParameterRow &row(const Parameter &parameter, unsigned number) {
    const unsigned index = parameter.first + number;
    for (ParameterRow &each : m_rows)
      if (each.space == parameter.space && each.index == index)
        return each;
    return m_rows.emplace_back(ParameterRow{parameter.space, index, {}});
  }

  void addMatrix(const Parameter &parameter, const glm::mat4 &matrix) {
    for (unsigned i = 0; i < parameter.count; ++i)
      for (int column = 0; column < 4; ++column)
        row(parameter, i).value[std::size_t(column)] = matrix[column][int(i)];
  }

  const Surroundings &m_surroundings;
  std::vector<ParameterRow> m_rows;
};

} // namespace

double animated(double value, const Parameter &parameter, double seconds) {
  if (!parameter.animation)
    return value;
  const auto &[kind, period] = *parameter.animation;
  if (kind.value == AnimationKind::Time)
    return value + seconds / period.value;
  if (kind.value == AnimationKind::Turn)
    return value;
  const double low = parameter.low.value, high = parameter.high.value;
  const double begin = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return low + (high - low) * within(kind.value, begin, seconds / period.value);
}

std::array<double, 4> valueAt(const Parameter &parameter, double seconds) {
  std::array<double, 4> value = {};
  std::size_t next = 0;
  for (std::size_t i = 0; i < 4 && next < parameter.values.size(); ++i)
    if (parameter.mask[i])
      value[i] = animated(parameter.values[next++].value, parameter, seconds);
  if (parameter.animation && parameter.animation->kind.value == AnimationKind::Turn)
    turn(parameter, seconds, value);
  return value;
}

std::vector<ParameterRow> rowsAt(const Panel &panel, double seconds,
                                 const Surroundings &surroundings) {
  Rows rows(surroundings);
  for (const Parameter &parameter : panel.parameters)
    rows.add(parameter, seconds);
  return rows.take();
}

} // namespace arbiter::scene
