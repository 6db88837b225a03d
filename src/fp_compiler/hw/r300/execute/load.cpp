#include "fp_compiler/hw/r300/execute/load.h"

#include "fp_compiler/hw/r300/execute/execute.h"
#include "fp_compiler/ir/fog.h"

namespace arbiter::fp::hw::r300 {

using ir::Vec4;

namespace {
template <typename F> Vec4 each(Vec4 value, F change) {
  for (float &component : value)
    component = change(component);
  return value;
}

Vec4 clipPosition(const Vec4 &window) {
  const float w = 1.0f / window[3];
  Vec4 clip = {0.0f, 0.0f, 0.0f, w};
  for (std::size_t i = 0; i < 3; ++i)
    clip[i] = (window[i] - kViewportOffset[i]) / kViewportScale[i] * w;
  return clip;
}

Vec4 valueOfParameter(const ir::Parameter &parameter, const ir::Inputs &inputs) {
  if (parameter.kind == ir::ParameterKind::Constant)
    return parameter.constant;
  return inputs.parameter ? inputs.parameter(parameter) : Vec4{};
}

Vec4 valueOf(const Constant &constant, const Surroundings &surroundings) {
  switch (constant.kind) {
  case Constant::Kind::Parameter:
    return valueOfParameter(surroundings.program.parameters[constant.index], surroundings.inputs);
  case Constant::Kind::Value:
    return constant.value;
  case Constant::Kind::RectangleScale:
    return {1.0f / kRectangleWidth, 1.0f / kRectangleHeight, 1.0f, 1.0f};
  case Constant::Kind::ViewportScale:
    return kViewportScale;
  case Constant::Kind::ViewportOffset:
    return kViewportOffset;
  case Constant::Kind::FogColor:
    return valueOfParameter(ir::stateRow(ir::StateItem::FogColor), surroundings.inputs);
  case Constant::Kind::FogFactors:
    return ir::fogFactors(
        valueOfParameter(ir::stateRow(ir::StateItem::FogParams), surroundings.inputs));
  }
  return {};
}
} // namespace

Vec4 constantOf(const Constant &constant, const Surroundings &surroundings) {
  return each(valueOf(constant, surroundings),
              [&](float value) { return ir::loaded(value, surroundings.numerics); });
}

Vec4 interpolantOf(std::uint16_t attribute, const Surroundings &surroundings) {
  const auto held = [&](float value) { return ir::held(value, surroundings.numerics); };
  const auto color = [&](float value) {
    return surroundings.numerics == Numerics::Fp24 ? fp24::color(value) : held(value);
  };
  if (attribute == kFogCoordinate)
    return {held(surroundings.inputs.fogCoordinate), 0.0f, 0.0f, 1.0f};
  if (attribute == kSecondaryColor)
    return each(surroundings.inputs.secondary, color);
  Vec4 value = {};
  if (attribute < surroundings.inputs.attributes.size())
    value = surroundings.inputs.attributes[attribute];
  switch (surroundings.program.attributes[attribute].kind) {
  case ir::AttributeKind::FogCoord:
    return {held(value[0]), 0.0f, 0.0f, 1.0f};
  case ir::AttributeKind::Position:
    return each(clipPosition(value), held);
  case ir::AttributeKind::ColorPrimary:
  case ir::AttributeKind::ColorSecondary:
    return each(value, color);
  default:
    return each(value, held);
  }
}

} // namespace arbiter::fp::hw::r300
