#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// A GLSL 1.20 expression of type vec4 for a row of GL state.
struct StateText {
  std::string text;
  /// A variable of the host's, which may be swizzled where it stands; else an expression that is
  /// worth a local variable.
  bool isVariable = true;
};

/// The host's built-in for a row of state, composed by hand where hosts disagree about the
/// built-in (light products' and scene colours' w, half-angle vectors, the fog scale). Empty for
/// rows that no built-in covers (program and palette matrices, texture environment colours): the
/// layer supplies those in arb_param.
[[nodiscard]] std::optional<StateText> stateText(const ir::StateRef &ref);

} // namespace arbiter::fp::glsl
