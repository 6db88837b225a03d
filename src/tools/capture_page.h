#pragma once
#include <string>

#include "tools/capture_index.h"

namespace arbiter::tools {

/// The index as one HTML page that needs nothing beside it: a table that sorts by a click on a
/// column, and for each program its source with line numbers, errors, counts, parameters, textures
/// and GLSL. Bytes that are not UTF-8, and control characters, are shown as \\xNN.
[[nodiscard]] std::string indexPage(const CaptureIndex &index);

} // namespace arbiter::tools
