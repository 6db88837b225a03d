#include "apps/tools/draw/gallery.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "apps/scene/document.h"
#include "util/suggest.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

/// Returns the gallery's folder; empty if there is none.
fs::path folder() {
  if (const char *const named = std::getenv("ARBITER_GALLERY"); named != nullptr && *named != 0)
    return named;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path &place :
       {self.parent_path() / ARBITER_GALLERY_FROM_BIN, fs::path(ARBITER_GALLERY_SOURCE)})
    if (fs::is_directory(place, error))
      return place.lexically_normal();
  return {};
}

bool hasTitle(const std::string &path) {
  const auto text = scene::readText(path);
  return text && scene::parsePanel(text.value()).title.written();
}

/// Returns the names of the documents, sorted. Skips files of further passes, which have no title.
std::vector<std::string> namesIn(const fs::path &gallery) {
  std::vector<std::string> names;
  std::error_code error;
  for (auto entry = fs::directory_iterator(gallery, error);
       !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == ".fp" && hasTitle(entry->path().string()))
      names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

GalleryError unknown(const std::string &name, const std::vector<std::string> &names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string_view near = nearest(name, views);
  std::string message = std::string(kGalleryScheme) + name + ": the gallery has no such document";
  if (!near.empty())
    return {message + "; did you mean " + kGalleryScheme + std::string(near) + "?"};
  for (std::size_t i = 0; i < names.size(); ++i)
    message += (i == 0 ? "; it has " : ", ") + names[i];
  return {message};
}

} // namespace

std::vector<std::string> galleryNames() {
  const fs::path gallery = folder();
  return gallery.empty() ? std::vector<std::string>() : namesIn(gallery);
}

Result<std::string, GalleryError> documentPath(const std::string &name) {
  if (!name.starts_with(kGalleryScheme))
    return name;
  const std::string wanted = name.substr(std::char_traits<char>::length(kGalleryScheme));
  const fs::path gallery = folder();
  if (gallery.empty())
    return GalleryError{name + ": no gallery is installed with this command"};
  const auto names = namesIn(gallery);
  if (!std::binary_search(names.begin(), names.end(), wanted))
    return unknown(wanted, names);
  return (gallery / (wanted + ".fp")).string();
}

} // namespace arbiter::tools
