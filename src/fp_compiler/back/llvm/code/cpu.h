#pragma once
#include <optional>
#include <string>

#include "fp_compiler/back/llvm/code/code.h"

namespace arbiter::fp::llvm_back {

/// Returns the processor to generate code for: this one if \p name is empty, else a lesser one of
/// the same architecture ("avx512", "avx2", "sse4.1", "neon"). Nothing if this processor cannot run
/// it or belongs to no family.
[[nodiscard]] std::optional<Cpu> chooseCpu(const std::string &name);

/// Returns the family's name as chooseCpu() takes it.
[[nodiscard]] const char *familyName(Cpu::Family family);

} // namespace arbiter::fp::llvm_back
