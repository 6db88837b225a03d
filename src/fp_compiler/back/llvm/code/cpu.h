#pragma once
#include <optional>
#include <string>

#include "fp_compiler/back/llvm/code/code.h"

namespace arbiter::fp::llvm_back {

/// The processor that code is made for: this one if \p name is empty, else a lesser one of the same
/// architecture ("avx512", "avx2", "sse4.1", "neon"). Nothing if this one cannot run it, or if
/// there is none of the families here at all.
[[nodiscard]] std::optional<Cpu> chooseCpu(const std::string &name);

/// The family's name, as chooseCpu() takes it.
[[nodiscard]] const char *familyName(Cpu::Family family);

} // namespace arbiter::fp::llvm_back
