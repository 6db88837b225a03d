#include <filesystem>

#include "apps/tools/commands.h"
#include "apps/tools/draw/gallery.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/launch.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

/// Returns the folder of this command.
fs::path ownFolder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// Returns the path of the window's executable: beside this command if installed, or in the build
/// tree.
std::string findWindow(const fs::path &here) {
  std::error_code error;
  for (const fs::path &place :
       {here / "arbiter-builder", here.parent_path() / "builder" / "view" / "arbiter-builder"})
    if (fs::exists(place, error))
      return place.string();
  return {};
}

/// Returns what to install if there is no window.
std::string remedy(const fs::path &here) {
  std::error_code error;
  const fs::path tree = here.parent_path().parent_path().parent_path(); // of src/apps/tools
  if (fs::exists(tree / "build.ninja", error))
    return "this build is without the window: install qt6-base-dev and qt6-base-dev-tools, then "
           "meson setup --reconfigure " +
           tree.string();
  return "the window is not installed: it is in the package arbiter-builder";
}

} // namespace

int builder(const BuilderArguments &arguments) {
  const fs::path here = ownFolder();
  const std::string window = findWindow(here);
  if (window.empty()) {
    complain(remedy(here));
    return kExitUsage;
  }
  if (const auto path = documentPath(arguments.document); !path) {
    complain(path.error().message);
    return kExitUsage;
  }
  std::vector<std::string> command = {window};
  if (!arguments.screenshot.empty())
    command.insert(command.end(), {"--screenshot", arguments.screenshot});
  if (!arguments.size.empty())
    command.insert(command.end(), {"--size", arguments.size});
  if (!arguments.document.empty())
    command.insert(command.end(), {"--", arguments.document});
  return execute({}, command);
}

} // namespace arbiter::tools
