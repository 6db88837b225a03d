#pragma once
#include <string_view>

#include "fp_compiler/front/reporter.h"

namespace arbiter::fp {

/// True if the text may be parsed: no longer than kMaxTextBytes, and with \p header, of ten bytes,
/// at its first one. Else the reason is reported.
[[nodiscard]] bool checkHeader(std::string_view header, std::string_view text, Reporter &reporter);

} // namespace arbiter::fp
