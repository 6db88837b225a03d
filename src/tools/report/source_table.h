#pragma once
#include <string>

#include "tools/check/checked_file.h"

namespace arbiter::tools {

/// The program's text as a table, a line a row (`<tr id=PREFIX-LINE>`), with what each line takes
/// where there is a model, and each diagnostic below its line. Any bytes; lines as the compiler
/// counts them.
/// \param prefix of the rows' ids: "p3"
[[nodiscard]] std::string sourceTable(const CheckedFile &file, const std::string &prefix);

} // namespace arbiter::tools
