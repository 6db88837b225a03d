#pragma once
#include <string>
#include <vector>

#include "util/result.h"

namespace arbiter::tools {

inline constexpr const char *kGalleryScheme = "gallery:";

struct GalleryError {
  std::string message;
};

/// Returns the path of a named document. `gallery:twirl` is twirl.fp in the gallery: the folder of
/// ARBITER_GALLERY, the installed one, or the build's source tree. Other names are paths. Fails if
/// there is no gallery, or no document of that name.
[[nodiscard]] Result<std::string, GalleryError> documentPath(const std::string &name);

/// Returns the names of the gallery's documents, sorted; empty if there is no gallery.
[[nodiscard]] std::vector<std::string> galleryNames();

} // namespace arbiter::tools
