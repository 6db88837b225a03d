#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/check/terminal.h"
#include "fp_compiler/diagnostic.h"

namespace arbiter::tools {

/// Returns fp::render() of a diagnostic. On a terminal the place, the kind, the caret and the hint
/// have GCC's colors.
[[nodiscard]] std::string rendered(std::string_view name, std::string_view text,
                                   const fp::Diagnostic &diagnostic, const Style &style);
/// Returns only the first line.
[[nodiscard]] std::string renderedLine(std::string_view name, std::string_view text,
                                       const fp::Diagnostic &diagnostic, const Style &style);
/// Returns all diagnostics, one after the other.
[[nodiscard]] std::string rendered(std::string_view name, std::string_view text,
                                   const std::vector<fp::Diagnostic> &diagnostics,
                                   const Style &style);

} // namespace arbiter::tools
