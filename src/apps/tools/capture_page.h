#pragma once
#include <string>

#include "apps/tools/capture_index.h"

namespace arbiter::tools {

/// Returns the index as one self-contained HTML page. It has a table whose columns sort by a click.
/// Each program has its source with line numbers, errors, counts, parameters, textures and GLSL.
/// Bytes that are not UTF-8, and control characters, are shown as \\xNN.
[[nodiscard]] std::string indexPage(const CaptureIndex &index);

} // namespace arbiter::tools
