#pragma once
#include <string_view>

#include "fp_compiler/front/reporter.h"

namespace arbiter::fp {

/// Returns whether the text has at most kMaxTextBytes. Reports an error if not.
[[nodiscard]] bool checkLength(std::string_view text, Reporter &reporter);

/// Returns whether the text may be parsed: it has at most kMaxTextBytes and begins with \p header.
/// Reports an error if not.
[[nodiscard]] bool checkHeader(std::string_view header, std::string_view text, Reporter &reporter);

/// Returns where the statements may begin in a text with a wrong header: after the first line if
/// that looks like a header, otherwise at the first byte.
[[nodiscard]] std::uint32_t endOfWrongHeader(std::string_view text);

} // namespace arbiter::fp
