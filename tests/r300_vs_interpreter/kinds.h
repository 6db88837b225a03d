#pragma once
#include <cstdint>
#include <span>

#include "fp_compiler/ir/ir.h"

namespace arbiter::r300 {

/// A way to make programs.
struct Kind {
  const char *name;
  fp::ir::Program (*make)(std::uint64_t seed);
  bool compared; ///< false: the values are undefined, only the rules are looked at
};

/// Those that make programs of any number.
[[nodiscard]] std::span<const Kind> generatedKinds();

/// Programs of files: make(i) is the i-th of all that addTexts() found.
[[nodiscard]] const Kind &textKind();
[[nodiscard]] std::uint64_t textCount();
/// Adds every fragment program of a folder, in the order of their names. False, with a message, if
/// there is none or one does not pass its check.
[[nodiscard]] bool addTexts(const char *folder);

} // namespace arbiter::r300
