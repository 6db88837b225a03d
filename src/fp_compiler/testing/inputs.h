#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::testing {

/// The results of a fragment or vertex, by result binding, so that programs with different tables
/// can be compared.
struct Outcome {
  /// Results by kind and index. Components that do not count are zero. A vertex result without any
  /// written component counts as not bound.
  std::map<std::pair<ir::OutputKind, int>, ir::Vec4> results;
  std::optional<float> depth;
  bool killed = false;
};

/// The inputs that a program is run on.
struct Made {
  std::uint64_t pixel = 0;
  Numerics numerics = Numerics::Host;
  /// True if one attribute or parameter component in four is one of kSpecials, such as an infinity,
  /// a NaN, or an end of the range.
  bool special = false;
  /// Called at each step, like Inputs::observer. It may end the run by an exception.
  std::function<void(const ir::Step &)> observer = {};
};

/// Runs a program on made-up attributes, parameters and texels, which depend only on \p made and on
/// the binding.
[[nodiscard]] Outcome outcome(const ir::Program &program, const Made &made);
[[nodiscard]] inline Outcome outcome(const ir::Program &program, std::uint64_t pixel) {
  return outcome(program, Made{pixel});
}
/// Runs a program on four neighbouring fragments: made.pixel and the three after it.
[[nodiscard]] std::array<Outcome, 4> quadOutcome(const ir::Program &program, const Made &made);

/// True if the outcomes are equal bit by bit. All NaNs are equal.
[[nodiscard]] bool same(const Outcome &a, const Outcome &b);

} // namespace arbiter::fp::testing
