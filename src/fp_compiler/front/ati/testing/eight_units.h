#pragma once
#include "fp_compiler/compiler.h"

namespace arbiter::fp::ati {

/// Returns limits of a card with eight texture units and 24 parameters of each kind.
inline CompileOptions eightUnits() {
  CompileOptions options;
  options.limits.textureCoords = options.limits.textureImageUnits = 8;
  options.limits.envParameters = options.limits.localParameters = 24;
  return options;
}

} // namespace arbiter::fp::ati
