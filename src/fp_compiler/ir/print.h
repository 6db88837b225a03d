#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ir {

/// Returns a listing of a program: tables first, then one instruction a line, without source spans.
/// Equal programs give equal text. It serves goldens and `arbiter compile --emit ir`.
[[nodiscard]] std::string print(const Program &program);
[[nodiscard]] std::string print(const Instruction &instruction);
/// Returns the ARB binding of a table row: "program.local[3]", "state.light[0].half".
[[nodiscard]] std::string bindingText(const Parameter &parameter);
[[nodiscard]] std::string bindingText(const Attribute &attribute,
                                      Language language = Language::ArbFragment);
[[nodiscard]] std::string bindingText(const Output &output);
/// Returns the name of a target: "1D", "SHADOW2D".
[[nodiscard]] const char *targetText(TexTarget target);

} // namespace arbiter::fp::ir
