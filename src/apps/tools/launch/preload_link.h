#pragma once
#include <string>

#include "apps/tools/launch/launch.h"

namespace arbiter::tools {

/// True if LD_PRELOAD would split the path, because it has a colon or white space.
[[nodiscard]] bool isCutByPreload(const std::string &path);

/// Returns the files by paths that LD_PRELOAD can hold. If the folder's path would be split, the
/// paths lead through a link in $XDG_RUNTIME_DIR/arbiter, which stays for later runs. Fails if the
/// file's name would be split, or if there is no folder for the link.
[[nodiscard]] Result<LayerFiles, LaunchError> preloadable(const LayerFiles &files);

} // namespace arbiter::tools
