#pragma once
#include <string>

#include "tools/report/program_set.h"

namespace arbiter::tools {

/// The report as one HTML page that needs nothing beside it (page/frame.h): counts of the set, a
/// histogram of slots a language, what does not fit and why, a table that sorts and filters, and a
/// folded section a program. Bytes that are not UTF-8, and control characters, are shown as \\xNN.
[[nodiscard]] std::string reportPage(const ProgramSet &set);

} // namespace arbiter::tools
