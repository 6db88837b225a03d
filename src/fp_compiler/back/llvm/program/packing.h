#pragma once
#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/ir/packing.h"

/// PK* and UP*, exactly as in ir/packing.h.
namespace arbiter::fp::llvm_back {

/// Packs a vector.
/// \param value x and y, or all four components
[[nodiscard]] Value *packed(Code &code, ir::Packing packing, const Vec &value);
/// Unpacks the components in \p needed; others are null.
[[nodiscard]] Vec unpacked(Code &code, ir::Packing packing, Value *value, unsigned needed);

} // namespace arbiter::fp::llvm_back
