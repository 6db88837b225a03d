#pragma once
#include <random>
#include <string>
#include <vector>

#include "fp_compiler/back/llvm/testing/sample_harness.h"

namespace arbiter::fp::llvm_back::testing {

struct Case {
  abi::SamplerKey key;
  SampleOptions options;
  std::array<int, 3> size = {1, 1, 1};
};

/// Returns cases that contain every possible pair of values of two properties (dimension, layout,
/// wrap modes, filters, comparison, size, lanes, bias ...).
[[nodiscard]] std::vector<Case> pairwiseCases(std::mt19937 &random);
[[nodiscard]] std::string describe(const Case &test);

} // namespace arbiter::fp::llvm_back::testing
