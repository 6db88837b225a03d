#pragma once
#include <string_view>

#include "fp_compiler/front/reporter.h"

namespace arbiter::fp {

/// True if the text is no longer than kMaxTextBytes. Else that is reported.
[[nodiscard]] bool checkLength(std::string_view text, Reporter &reporter);

/// True if the text may be parsed: no longer than kMaxTextBytes, and with \p header,
/// at its first byte. Else the reason is reported.
[[nodiscard]] bool checkHeader(std::string_view header, std::string_view text, Reporter &reporter);

/// Where the statements of a text may begin whose header is not the expected one: behind a first
/// line that begins as a header does, else at the first byte.
[[nodiscard]] std::uint32_t endOfWrongHeader(std::string_view text);

} // namespace arbiter::fp
