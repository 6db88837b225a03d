#pragma once
#include <optional>
#include <string>

#include "apps/scene/panel/panel.h"

namespace arbiter::scene {

/// Returns the panel of a file that is a later pass or a vertex program of a document in its folder
/// or the one above, with its diagnostics in that document. Among several documents it prefers one
/// where the panel has no errors. Returns nothing if no document names the file.
/// \param text of the file, instead of the stored one
[[nodiscard]] std::optional<Panel> panelInItsDocument(const std::string &path,
                                                      const std::string &text);

} // namespace arbiter::scene
