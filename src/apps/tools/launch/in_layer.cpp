#include "apps/tools/launch/in_layer.h"

#include <GL/arbiter.h>
#include <dlfcn.h>

#include "apps/tools/input.h"

namespace arbiter::tools {

Result<Launch, LaunchError> layerLaunch(const LayerArguments &arguments) {
  auto files = findLayer(arguments.library);
  if (!files)
    return files.error();
  auto environment = layerEnvironment(files.value(), arguments);
  if (!environment)
    return environment.error();
  return Launch{std::move(files).value(), std::move(environment).value()};
}

int executeInLayer(const LayerArguments &arguments, std::vector<std::string> argv) {
  const auto launch = layerLaunch(arguments);
  if (!launch) {
    complain(launch.error().message);
    return kExitUsage;
  }
  argv[0] = "/proc/self/exe"; // argv[0] may be relative to an earlier PATH
  argv.insert(argv.begin() + 2, "--in-layer");
  return execute(launch.value().environment, argv);
}

bool isInLayer() {
  // RTLD_NOLOAD returns a handle only if the preload worked.
  if (::dlopen(ARBITER_PRELOAD_LIBRARY, RTLD_NOLOAD | RTLD_LAZY) != nullptr)
    return true;
  complain("the layer was not loaded into this process");
  return false;
}

} // namespace arbiter::tools
