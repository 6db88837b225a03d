#pragma once
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::ir {

/// A listing of a program, the same text for the same program: tables first, then one instruction
/// a line. Spans are left out. For goldens and `arbiter compile --emit ir`.
[[nodiscard]] std::string print(const Program &program);
[[nodiscard]] std::string print(const Instruction &instruction);
/// The ARBfp binding that a table row stands for: "program.local[3]", "state.light[0].half".
[[nodiscard]] std::string bindingText(const Parameter &parameter);
[[nodiscard]] std::string bindingText(const Attribute &attribute,
                                      Language language = Language::ArbFragment);
[[nodiscard]] std::string bindingText(const Output &output);
/// "1D", "SHADOW2D"
[[nodiscard]] const char *targetText(TexTarget target);

} // namespace arbiter::fp::ir
