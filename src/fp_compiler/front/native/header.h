#pragma once
#include <optional>
#include <string_view>

#include "fp_compiler/front/reporter.h"
#include "fp_compiler/ir/interface.h"

namespace arbiter::fp::native {

/// Returns the target of a header of NVIDIA's languages, whatever its version. "!!FP2.0" and
/// "!!FCP1.0" belong to fragment programs. Returns nothing for any other text.
[[nodiscard]] std::optional<ir::Language> stageOfHeader(std::string_view text);

/// Reports a header that has a target by stageOfHeader() but is not a language of \p target.
/// \error native_header at the first byte that no language has, or after "!!" if another target has
/// the header
void refuseHeader(ir::Language target, std::string_view text, Reporter &reporter);

} // namespace arbiter::fp::native
