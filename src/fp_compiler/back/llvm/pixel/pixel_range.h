#pragma once
#include "fp_compiler/back/llvm/code/code.h"

namespace arbiter::fp::llvm_back {

/// What is known of a float in every lane, from the instructions that make it.
struct Range {
  float low, high; ///< infinities where nothing is known
  bool mayBeNan;
  [[nodiscard]] bool within(float least, float most) const {
    return !mayBeNan && low >= least && high <= most;
  }
};
[[nodiscard]] Range rangeOf(const Value *value);

} // namespace arbiter::fp::llvm_back
