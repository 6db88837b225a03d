#include "fp_compiler/combiners/values.h"

#include <algorithm>
#include <cmath>

namespace arbiter::fp::combiners {

using ir::Opcode;
using ir::Source;
using ir::Target;

namespace {

/// Clamps a bound to the range of floats; a bound beyond it means unbounded.
float bounded(double value) {
  return float(std::clamp(value, double(-Value::kAny), double(Value::kAny)));
}

struct Range {
  float low, high;
};

Range rangeOfProduct(const Value &a, const Value &b) {
  const double corners[] = {double(a.low) * double(b.low), double(a.low) * double(b.high),
                            double(a.high) * double(b.low), double(a.high) * double(b.high)};
  const auto [least, most] = std::minmax_element(std::begin(corners), std::end(corners));
  return {bounded(*least), bounded(*most)};
}

} // namespace

Target Values::fresh(Half half) {
  return m_builder.temporary().mask(half == Half::Rgb ? "xyz" : "w");
}

Value Values::emit(Half half, Opcode opcode, std::initializer_list<Source> operands, float low,
                   float high) {
  const Target to = fresh(half);
  m_builder.op(opcode, to, operands);
  return {to.read(), low, high, {}};
}

Value Values::literal(float number) {
  const auto known = std::find_if(m_literals.begin(), m_literals.end(),
                                  [&](const Value &value) { return value.is(number); });
  if (known != m_literals.end())
    return *known;
  return m_literals.emplace_back(Value{m_builder.constant(number), number, number, number});
}

Value Values::atLeast(Half half, const Value &value, float bound) {
  if (value.literal)
    return literal(std::max(*value.literal, bound));
  if (value.low >= bound)
    return value;
  if (value.beneath && bound <= value.high) {
    const Value::Beneath &from = *value.beneath;
    return clamped(half, {from.source, from.low, from.high, {}}, bound, value.high);
  }
  return emit(half, Opcode::Max, {value.source, literal(bound).source}, bound,
              std::max(value.high, bound));
}

Value Values::atMost(Half half, const Value &value, float bound) {
  if (value.literal)
    return literal(std::min(*value.literal, bound));
  if (value.high <= bound)
    return value;
  return emit(half, Opcode::Min, {value.source, literal(bound).source}, std::min(value.low, bound),
              bound);
}

Value Values::clamped(Half half, const Value &value, float low, float high) {
  Value result = atMost(half, atLeast(half, value, low), high);
  if (!value.literal && !value.beneath)
    result.beneath = {value.source, value.low, value.high};
  return result;
}

Value Values::negated(const Value &value) {
  if (value.literal)
    return literal(-*value.literal);
  return {-value.source, -value.high, -value.low, {}};
}

Value Values::scaled(Half half, const Value &value, float scale, float bias) {
  if (value.literal)
    return literal(*value.literal * scale + bias);
  if (bias == 0.0f)
    return product(half, value, literal(scale));
  return multiplyAdd(half, value, literal(scale), literal(bias));
}

Value Values::product(Half half, const Value &a, const Value &b) {
  if (a.literal && b.literal)
    return literal(*a.literal * *b.literal);
  if (a.literal)
    return product(half, b, a);
  if (b.is(0.0f))
    return b;
  if (b.is(1.0f))
    return a;
  if (b.is(-1.0f))
    return negated(a);
  const Range range = rangeOfProduct(a, b);
  Value result = emit(half, Opcode::Mul, {a.source, b.source}, range.low, range.high);
  if (m_fx9 && (b.is(one()) || b.is(-one())))
    result.timesOne = b.is(one()) ? a.source : -a.source;
  return result;
}

Value Values::multiplyAdd(Half half, const Value &a, const Value &b, const Value &c) {
  const auto trivial = [](const Value &v) { return v.is(0.0f) || v.is(1.0f) || v.is(-1.0f); };
  const bool ofRegisters = c.timesOne && (a.is(one()) || b.is(one()));
  if (trivial(a) || trivial(b) || c.is(0.0f) || (a.literal && b.literal) || ofRegisters)
    return sum(half, product(half, a, b), c);
  const Range range = rangeOfProduct(a, b);
  return emit(half, Opcode::Mad, {a.source, b.source, c.source},
              bounded(double(range.low) + double(c.low)),
              bounded(double(range.high) + double(c.high)));
}

Value Values::dot(const Value &a, const Value &b) {
  if (a.is(0.0f) || b.is(0.0f))
    return literal(0.0f);
  const Range range = rangeOfProduct(a, b);
  return emit(Half::Rgb, Opcode::Dp3, {a.source, b.source}, bounded(3.0 * double(range.low)),
              bounded(3.0 * double(range.high)));
}

Value Values::sum(Half half, const Value &a, const Value &b) {
  if (a.literal && b.literal)
    return literal(*a.literal + *b.literal);
  if (a.is(0.0f))
    return b;
  if (b.is(0.0f))
    return a;
  if (a.timesOne && b.timesOne)
    return product(half, sum(half, registerOf(a), registerOf(b)), literal(one()));
  return emit(half, Opcode::Add, {a.source, b.source}, bounded(double(a.low) + double(b.low)),
              bounded(double(a.high) + double(b.high)));
}

Value Values::registerOf(const Value &product) const {
  return {*product.timesOne, product.low / one(), product.high / one(), {}};
}

Value Values::roundedDown(Half half, const Value &value) {
  if (value.literal)
    return literal(std::floor(*value.literal));
  return emit(half, Opcode::Flr, {value.source}, std::floor(value.low), std::floor(value.high));
}

Value Values::registered(Half half, const Value &given) {
  if (!m_fx9)
    return given;
  const Value inRange = atMost(half, atLeast(half, given, -1.0f), 1.0f);
  return roundedDown(half, scaled(half, inRange, one(), 0.5f));
}

Value Values::fromProduct(Half half, const Value &product, float scale, bool biased) {
  if (!m_fx9)
    return scaled(half, product, scale, biased ? -oneHalf() * scale : 0.0f);
  const float bias = biased ? -oneHalf() * scale : 0.0f;
  if (product.timesOne && scale >= 1.0f)
    return scaled(half, registerOf(product), scale, bias);
  if (product.timesOne)
    return roundedDown(half, scaled(half, registerOf(product), scale, bias + 0.5f));
  // The exact value is a multiple of 1 / 255 of a number, or of half that. A quarter of this step
  // does not change the result, but keeps ties clear of rounding errors of the factor.
  const float quarter = 0.25f * std::min(scale, 1.0f) / one();
  return roundedDown(half, scaled(half, product, scale / one(), bias + 0.5f + quarter));
}

Value Values::given(Half half, const Value &value) {
  return m_fx9 ? product(half, value, literal(1.0f / one())) : value;
}

Value Values::chosen(Half half, const Value &chooser, const Value &below, const Value &other) {
  if (chooser.literal)
    return *chooser.literal < oneHalf() ? below : other;
  if (below.timesOne && other.timesOne)
    return product(half, chosen(half, chooser, registerOf(below), registerOf(other)),
                   literal(one()));
  // The difference of two floats has the exact sign.
  const Value distance =
      emit(Half::Alpha, Opcode::Sub, {chooser.source.swz("w"), literal(oneHalf()).source},
           -Value::kAny, Value::kAny);
  return emit(half, Opcode::Cmp, {distance.source.swz("w"), below.source, other.source},
              std::min(below.low, other.low), std::max(below.high, other.high));
}

Value Values::blended(Half half, const Value &a, const Value &b, const Value &c) {
  if (a.is(one()))
    return product(half, b, literal(one()));
  if (a.is(0.0f))
    return product(half, c, literal(one()));
  if (m_fx9) {
    const Value difference = sum(half, b, negated(c));
    return sum(half, product(half, a, difference), product(half, c, literal(one())));
  }
  if (c.is(0.0f))
    return product(half, a, b);
  const bool between = a.low >= 0.0f && a.high <= 1.0f;
  return emit(half, Opcode::Lrp, {a.source, b.source, c.source},
              between ? std::min(b.low, c.low) : -Value::kAny,
              between ? std::max(b.high, c.high) : Value::kAny);
}

Value Values::mapped(Half half, const Value &value, Mapping mapping) {
  if (mapping == Mapping::SignedIdentity)
    return value;
  if (mapping == Mapping::SignedNegate)
    return negated(value);
  const Value positive = atLeast(half, value, 0.0f);
  switch (mapping) {
  case Mapping::UnsignedInvert: {
    const Value unit = atMost(half, positive, one());
    return unit.literal ? literal(one() - *unit.literal) : sum(half, literal(one()), negated(unit));
  }
  case Mapping::ExpandNormal:
    return scaled(half, positive, 2.0f, -one());
  case Mapping::ExpandNegate:
    return scaled(half, positive, -2.0f, one());
  case Mapping::HalfBiasNormal:
    return sum(half, positive, literal(-oneHalf()));
  case Mapping::HalfBiasNegate:
    return sum(half, literal(oneHalf()), negated(positive));
  default:
    return positive;
  }
}

} // namespace arbiter::fp::combiners
