#pragma once
#include <string>

#include "fp_compiler/compiler.h"

/// What a program takes of a card: what advice is measured by.
namespace arbiter::tools::advise {

/// The counts of the profile's model, or those of the API where a profile has none.
struct Cost {
  std::uint32_t alu = 0;   ///< ALU slots
  std::uint32_t tex = 0;   ///< TEX slots
  std::uint32_t nodes = 0; ///< texture nodes (indirections)
  bool fits = false;       ///< within the native limits
  bool operator==(const Cost &) const = default;

  [[nodiscard]] std::uint32_t slots() const { return alu + tex; }
};

/// Requires: check.ok().
[[nodiscard]] Cost costOf(const fp::CheckResult &check);

/// One of the counts is smaller, none is larger, and what fitted still fits.
[[nodiscard]] bool falls(const Cost &from, const Cost &to);

/// Fewer slots in all, whatever becomes of one kind, within the limits if it was: what advice that
/// moves work into a texture must gain.
[[nodiscard]] bool fewerSlots(const Cost &from, const Cost &to);

/// The order of what is worth more: fewer slots, then fewer nodes.
[[nodiscard]] bool cheaper(const Cost &a, const Cost &b);

/// "ALU 4 -> 1, nodes 2 -> 1": the counts that change.
[[nodiscard]] std::string changeText(const Cost &from, const Cost &to);

} // namespace arbiter::tools::advise
