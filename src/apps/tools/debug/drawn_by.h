#pragma once
#include <string>

#include "apps/tools/temporary_folder.h"

namespace arbiter::tools::debug {

/// Reads from the layer's statistics whether the rasterizer or the host drew. The rasterizer leaves
/// draws to the host if it has no code for them. Owns a temporary folder for the statistics.
class DrawnBy {
public:
  /// Returns the file's path; empty if no folder could be made.
  [[nodiscard]] std::string path() const;
  /// Returns "the rasterizer left 3 of 5 draws to the host: numerics". Returns "" if the rasterizer
  /// drew all, or if nothing was written. Requires: the drawing process has ended.
  [[nodiscard]] std::string note() const;

private:
  TemporaryFolder m_folder{"arbiter-debug"};
};

/// Returns the note for the text of a statistics file.
[[nodiscard]] std::string drawnByNote(const std::string &statistics);

} // namespace arbiter::tools::debug
