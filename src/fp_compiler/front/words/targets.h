#pragma once
#include <string_view>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp {

/// A texture target as a program writes it.
struct TargetRow {
  std::string_view word;
  ir::TexTarget target;
  bool shadow;
};

/// Returns the row of a word; nullptr if it is no target.
[[nodiscard]] const TargetRow *findTarget(std::string_view word);
/// Returns the word of a target.
[[nodiscard]] std::string_view spelling(ir::TexTarget target);

} // namespace arbiter::fp
