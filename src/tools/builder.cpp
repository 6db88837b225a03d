#include <filesystem>

#include "tools/commands.h"
#include "tools/draw/gallery.h"
#include "tools/input.h"
#include "tools/launch/launch.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

/// Returns the path of the window's executable: beside this command if installed, or in the build
/// tree.
std::string findWindow() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  const fs::path here = self.parent_path();
  for (const fs::path &place :
       {here / "arbiter-builder", here.parent_path() / "builder" / "view" / "arbiter-builder"})
    if (fs::exists(place, error))
      return place.string();
  return {};
}

} // namespace

int builder(const BuilderArguments &arguments) {
  const std::string window = findWindow();
  if (window.empty()) {
    complain("arbiter-builder is not installed beside this command; it is built where Qt 6 is "
             "(qt6-base-dev)");
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
