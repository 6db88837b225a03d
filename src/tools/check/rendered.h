#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "tools/check/terminal.h"

namespace arbiter::tools {

/// fp::render() of a diagnostic; on a terminal with the place, the kind, the caret and the hint in
/// the colours that GCC gives them.
[[nodiscard]] std::string rendered(std::string_view name, std::string_view text,
                                   const fp::Diagnostic &diagnostic, const Style &style);
/// Its first line alone.
[[nodiscard]] std::string renderedLine(std::string_view name, std::string_view text,
                                       const fp::Diagnostic &diagnostic, const Style &style);
/// Each of them, one after the other.
[[nodiscard]] std::string rendered(std::string_view name, std::string_view text,
                                   const std::vector<fp::Diagnostic> &diagnostics,
                                   const Style &style);

} // namespace arbiter::tools
