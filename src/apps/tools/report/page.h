#pragma once
#include <string>

#include "apps/tools/report/program_set.h"

namespace arbiter::tools {

/// Returns the report as one self-contained HTML page (page/frame.h). It contains the set's counts,
/// a histogram of slots for each language, and the programs that do not fit, with reasons. A table
/// can be sorted and filtered, and each program has a folded section. Bytes that are not UTF-8, and
/// control characters, are shown as \\xNN.
[[nodiscard]] std::string reportPage(const ProgramSet &set);

} // namespace arbiter::tools
