#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::testing {

/// What a fragment or vertex ends up as, by result binding, so that programs with different tables
/// compare.
struct Outcome {
  /// By kind and index; components that do not count are zero. A vertex result of which nothing is
  /// written is as if it were not bound.
  std::map<std::pair<ir::OutputKind, int>, ir::Vec4> results;
  std::optional<float> depth;
  bool killed = false;
};

/// What a program is run on.
struct Made {
  std::uint64_t pixel = 0;
  Numerics numerics = Numerics::Host;
  /// One attribute or parameter component in four is one of kSpecials: an infinity, a NaN, an end
  /// of the range.
  bool special = false;
  /// Sees each step, as Inputs::observer does; it may end the run by an exception.
  std::function<void(const ir::Step &)> observer = {};
};

/// Runs a program on made-up attributes, parameters and texels that depend on \p made and on the
/// binding alone.
[[nodiscard]] Outcome outcome(const ir::Program &program, const Made &made);
[[nodiscard]] inline Outcome outcome(const ir::Program &program, std::uint64_t pixel) {
  return outcome(program, Made{pixel});
}
/// The same of four fragments that are neighbours: made.pixel and the three behind it.
[[nodiscard]] std::array<Outcome, 4> quadOutcome(const ir::Program &program, const Made &made);

/// Equal bit by bit, all NaNs being one.
[[nodiscard]] bool same(const Outcome &a, const Outcome &b);

} // namespace arbiter::fp::testing
