#pragma once
#include "fp_compiler/back/llvm/code/code.h"

namespace arbiter::fp::llvm_back {

/// The range of a float over all lanes, derived from the instructions that compute it.
struct Range {
  float low, high; ///< infinities if unknown
  bool mayBeNan;
  [[nodiscard]] bool within(float least, float most) const {
    return !mayBeNan && low >= least && high <= most;
  }
};
[[nodiscard]] Range rangeOf(const Value *value);

} // namespace arbiter::fp::llvm_back
