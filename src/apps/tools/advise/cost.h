#pragma once
#include <string>

#include "fp_compiler/compiler.h"

/// Measures a program's use of a card's resources, to compare suggestions.
namespace arbiter::tools::advise {

/// The counts of the profile's model, or the API's if the profile has no model.
struct Cost {
  std::uint32_t alu = 0;   ///< ALU slots
  std::uint32_t tex = 0;   ///< TEX slots
  std::uint32_t nodes = 0; ///< true if within the native limits
  bool fits = false;       ///< within the native limits
  bool operator==(const Cost &) const = default;

  [[nodiscard]] std::uint32_t slots() const { return alu + tex; }
};

/// Returns a program's cost. Requires: check.ok().
[[nodiscard]] Cost costOf(const fp::CheckResult &check);

/// True if a count falls, none rises, and a program that fitted still fits.
[[nodiscard]] bool falls(const Cost &from, const Cost &to);

/// True if the sum of the slots falls, and a program that fitted still fits. Advice that moves work
/// into a texture must pass this test.
[[nodiscard]] bool fewerSlots(const Cost &from, const Cost &to);

/// Orders by gain: fewer slots first, then fewer nodes.
[[nodiscard]] bool cheaper(const Cost &a, const Cost &b);

/// Returns the counts that change: "ALU 4 -> 1, nodes 2 -> 1".
[[nodiscard]] std::string changeText(const Cost &from, const Cost &to);

} // namespace arbiter::tools::advise
