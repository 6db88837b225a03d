#pragma once
#include <optional>
#include <string>

#include "scene/panel/panel.h"

namespace arbiter::scene {

/// The panel of a file that is a further pass or a vertex program of a document in its folder or in
/// the one above, with the diagnostics that it has there; of several documents, of one in which
/// nothing is wrong with it. None where no document names the file.
/// \param text of the file, whatever is stored
[[nodiscard]] std::optional<Panel> panelInItsDocument(const std::string &path,
                                                      const std::string &text);

} // namespace arbiter::scene
