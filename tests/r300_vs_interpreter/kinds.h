#pragma once
#include <cstdint>
#include <span>

#include "fp_compiler/ir/ir.h"

namespace arbiter::r300 {

/// A way to make programs.
struct Kind {
  const char *name;
  fp::ir::Program (*make)(std::uint64_t seed);
  bool compared; ///< false: the values are undefined, so that only the rules are checked
};

/// Returns the kinds that generate programs.
[[nodiscard]] std::span<const Kind> generatedKinds();

/// Returns the kind whose make(i) returns the i-th program that addTexts() found.
[[nodiscard]] const Kind &textKind();
[[nodiscard]] std::uint64_t textCount();
/// Adds every fragment program of a folder, in the order of their names. Returns false, with a
/// message, if there is none or one is invalid.
[[nodiscard]] bool addTexts(const char *folder);

} // namespace arbiter::r300
