#include "fp_compiler/ir/fog.h"

namespace arbiter::fp::ir {

Vec4 fogFactors(const Vec4 &params) {
  constexpr float kOneOverLn2 = 1.442695041f, kOneOverRootLn2 = 1.201122409f;
  const float density = params[0], start = params[1], end = params[2];
  const float scale = start == end ? 0x1p40f : 1.0f / (end - start);
  return {-scale, end * scale, -(density * kOneOverLn2), density * kOneOverRootLn2};
}

Parameter stateRow(StateItem item) {
  Parameter parameter;
  parameter.kind = ParameterKind::State;
  parameter.state.item = item;
  return parameter;
}

} // namespace arbiter::fp::ir
