#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::testing {

/// What a fragment ends up as, by result binding, so that programs with different tables compare.
struct Outcome {
  std::array<std::optional<ir::Vec4>, 4> colors;
  std::optional<float> depth;
  bool killed = false;
};

/// Runs a program on made-up attributes, parameters and texels that depend on \p pixel and on the
/// binding alone.
[[nodiscard]] Outcome outcome(const ir::Program &program, std::uint64_t pixel);

/// Equal bit by bit, all NaNs being one.
[[nodiscard]] bool same(const Outcome &a, const Outcome &b);

} // namespace arbiter::fp::testing
