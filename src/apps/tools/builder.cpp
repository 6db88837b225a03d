#include <filesystem>
#include <utility>

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

/// Returns the command line of the window, whose options have the same names.
std::vector<std::string> commandOf(const std::string &window, const BuilderArguments &arguments) {
  const std::pair<const char *, const std::string &> options[] = {
      {"--screenshot", arguments.screenshot},
      {"--size", arguments.size},
      {"--colors", arguments.colors},
      {"--panel", arguments.panel},
      {"--edit", arguments.edit},
      {"--pixel", arguments.pixel},
      {"--watch", arguments.watch},
      {"--attach", arguments.attach}};
  std::vector<std::string> command = {window};
  for (const auto &[name, value] : options)
    if (!value.empty())
      command.insert(command.end(), {name, value});
  if (arguments.small)
    command.emplace_back("--small");
  if (!arguments.document.empty())
    command.insert(command.end(), {"--", arguments.document});
  return command;
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
  return execute({}, commandOf(window, arguments));
}

} // namespace arbiter::tools
