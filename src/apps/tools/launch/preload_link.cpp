#include "apps/tools/launch/preload_link.h"

#include <filesystem>
#include <unistd.h>

#include "control/address.h"
#include "util/hash.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

LaunchError cannotHold(const std::string &path, const std::string &why) {
  return {path + ": LD_PRELOAD cannot hold a path with a colon or a space" + why};
}

/// Returns a link to the folder; makes it if needed.
Result<fs::path, LaunchError> linkTo(const fs::path &folder) {
  const auto runtime = control::socketFolder();
  if (!runtime)
    return cannotHold(folder, ", and a link to it was not made: " + runtime.error().message);
  const fs::path link = fs::path(runtime.value()) / ("layer-" + toHex(hashBytes(folder.string())));
  std::error_code error;
  if (fs::read_symlink(link, error) == folder)
    return link;
  // Another process may make the link at the same time, so that a finished link is renamed into
  // place.
  const fs::path made = link.string() + "." + std::to_string(getpid());
  fs::create_directory_symlink(folder, made, error);
  if (!error)
    fs::rename(made, link, error);
  if (error)
    return cannotHold(folder, ", and a link to it was not made: " + error.message());
  return link;
}

/// Replaces `folder` by `link` if the path begins with it.
std::string through(const std::string &path, const std::string &folder, const std::string &link) {
  return path.starts_with(folder + "/") ? link + path.substr(folder.size()) : path;
}

} // namespace

bool isCutByPreload(const std::string &path) {
  return path.find_first_of(": \t\n") != std::string::npos;
}

Result<LayerFiles, LaunchError> preloadable(const LayerFiles &files) {
  if (!isCutByPreload(files.preload))
    return files;
  const fs::path preload = files.preload;
  if (isCutByPreload(preload.filename()))
    return cannotHold(files.preload, "");
  const std::string folder = preload.parent_path();
  const auto link = linkTo(folder);
  if (!link)
    return link.error();
  if (isCutByPreload(link.value()))
    return cannotHold(link.value(), "");
  return LayerFiles{.preload = through(files.preload, folder, link.value()),
                    .preloaded = through(files.preloaded, folder, link.value()),
                    .preloads = files.preloads,
                    .osmesaFolder = through(files.osmesaFolder, folder, link.value())};
}

} // namespace arbiter::tools
