#pragma once
#include <string>
#include <vector>

#include "util/result.h"

namespace arbiter::tools {

inline constexpr const char *kGalleryScheme = "gallery:";

struct GalleryError {
  std::string message;
};

/// What a command line names: `gallery:twirl` is the document twirl.fp of the gallery that was
/// installed with this command (or of the folder that ARBITER_GALLERY names, or of the build's
/// source tree); any other name is itself. Errors: no gallery, no document of that name.
[[nodiscard]] Result<std::string, GalleryError> documentPath(const std::string &name);

/// The names of its documents, sorted; none where there is no gallery.
[[nodiscard]] std::vector<std::string> galleryNames();

} // namespace arbiter::tools
