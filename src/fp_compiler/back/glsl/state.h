#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// A row of GL state as a GLSL 1.20 expression of type vec4.
struct StateText {
  std::string text;
  /// True for a built-in variable, which can be swizzled in place. False for an expression, which
  /// should go into a local variable.
  bool isVariable = true;
};

/// Returns the GLSL for a row of state, usually the host's built-in. It is an explicit expression
/// where hosts disagree about the built-in: w of light products and scene colours, half-angle
/// vectors, the fog scale. Rows without a built-in give nothing: program and palette matrices,
/// texture environment colours. The layer supplies those in arb_param.
[[nodiscard]] std::optional<StateText> stateText(const ir::StateRef &ref);

} // namespace arbiter::fp::glsl
