#pragma once
#include <optional>
#include <string>

#include "fp_compiler/ir/evaluate.h"

/// Whether what the chip makes of a fragment is what the program says, as far as the chip's
/// arithmetic lets that be said.
namespace arbiter::r300 {

/// A value of the reference, and how far the chip's may be from it. The program is run again with
/// each operation's operands and results moved by what the chip's way to compute it may cost:
/// other orders of sums, polynomials for SIN, COS and SCS, POW through LG2 and EX2.
struct Expected {
  float value = 0;
  float slack = 0;
  bool comparable = true; ///< false: the moved runs are too far apart to say anything
};

struct Expectation {
  bool comparable = true; ///< false: the moved runs do not agree on KIL
  bool killed = false;
  std::vector<std::array<Expected, 4>> outputs;
  std::optional<Expected> depth;
};

[[nodiscard]] Expectation expect(const fp::ir::Program &program, const fp::ir::Inputs &inputs,
                                 std::uint64_t seed);

struct Verdict {
  int compared = 0, skipped = 0;
  float error = 0;  ///< the worst, as a share of its slack: above 1 is a failure
  std::string what; ///< of the worst
};
[[nodiscard]] Verdict judge(const fp::ir::Program &program, const Expectation &expected,
                            const fp::ir::Evaluation &seen);

} // namespace arbiter::r300
