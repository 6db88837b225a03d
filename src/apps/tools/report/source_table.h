#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"

namespace arbiter::tools {

/// Returns the program's text as a table with one row per line (`<tr id=PREFIX-LINE>`). Each line
/// shows its cost if there is a model, and each diagnostic follows its line. Accepts any bytes, and
/// counts lines as the compiler does.
/// \param prefix of the rows' ids: "p3"
[[nodiscard]] std::string sourceTable(const CheckedFile &file, const std::string &prefix);

} // namespace arbiter::tools
