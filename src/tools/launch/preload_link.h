#pragma once
#include <string>

#include "tools/launch/launch.h"

namespace arbiter::tools {

/// True if LD_PRELOAD would take the path for several: it has a colon or white space.
[[nodiscard]] bool isCutByPreload(const std::string &path);

/// Returns the same files by paths that LD_PRELOAD can hold. Where the folder's path is cut, they
/// lead through a link in $XDG_RUNTIME_DIR/arbiter, which stays for later runs. Errors: the file's
/// name is cut; there is no such folder for the link.
[[nodiscard]] Result<LayerFiles, LaunchError> preloadable(const LayerFiles &files);

} // namespace arbiter::tools
