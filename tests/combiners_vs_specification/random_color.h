#pragma once
#include <algorithm>
#include <cmath>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/random.h"

/// Returns a color in [0,1].
/// \param fx9 avoids components that Numerics::Fx9 could round either way
inline arbiter::fp::combiners::Color randomColor(arbiter::fp::testing::Random &random, bool fx9) {
  arbiter::fp::combiners::Color value;
  for (double &c : value) {
    c = double(random.real(0.0f, 1.0f));
    if (fx9)
      c = std::clamp((std::round(c * 255.0) + double(random.real(-0.4f, 0.4f))) / 255.0, 0.0, 1.0);
  }
  return value;
}
