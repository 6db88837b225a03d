#pragma once
#include <string>

#include "apps/tools/report/program_set.h"

namespace arbiter::tools {

/// Returns the report as JSON (ARBITER_REPORT_SCHEMA of GL/arbiter.h, described in arbiter(1)).
[[nodiscard]] std::string reportJson(const ProgramSet &set);

} // namespace arbiter::tools
