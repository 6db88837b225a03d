#pragma once
#include <optional>
#include <string_view>

#include "fp_compiler/front/reporter.h"
#include "fp_compiler/ir/interface.h"

namespace arbiter::fp::native {

/// The target of the language that a header of NVIDIA's names, whatever its version: "!!FP2.0" and
/// "!!FCP1.0" are a fragment program's. Nothing for any other text.
[[nodiscard]] std::optional<ir::Language> stageOfHeader(std::string_view text);

/// Reports a header for which stageOfHeader() has an answer, but which is none of the languages of
/// \p target.
/// \error native-header its first byte that no language has; behind "!!" if another target has it
void refuseHeader(ir::Language target, std::string_view text, Reporter &reporter);

} // namespace arbiter::fp::native
