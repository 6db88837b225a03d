#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ir/evaluate.h"

/// Decides whether the chip's result for a fragment matches the program, as far as the chip's
/// arithmetic allows.
namespace arbiter::r300 {

/// A value of the reference, and the tolerance for the chip's value. The program is run repeatedly.
/// Each run moves the operands and results of each operation by the error of the chip's way to
/// compute it: other orders of sums, polynomials for SIN, COS and SCS, POW through LG2 and EX2.
struct Expected {
  float value = 0;
  float slack = 0;
  bool comparable = true; ///< false: the moved runs differ too much to judge
};

struct Expectation {
  bool comparable = true; ///< false: the moved runs disagree on KIL
  bool killed = false;
  std::vector<std::array<Expected, 4>> outputs;
  std::optional<Expected> depth;
};

[[nodiscard]] Expectation expect(const fp::ir::Program &program, const fp::ir::Inputs &inputs,
                                 std::uint64_t seed);

struct Verdict {
  int compared = 0, skipped = 0;
  float error = 0;  ///< the worst, relative to its slack: above 1 is a failure
  std::string what; ///< description of the worst
};
[[nodiscard]] Verdict judge(const fp::ir::Program &program, const Expectation &expected,
                            const fp::ir::Evaluation &seen);

} // namespace arbiter::r300
