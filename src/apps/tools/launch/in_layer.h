#pragma once
#include "apps/tools/launch/launch.h"

/// Starts commands, and this command's own work, under the layer.
namespace arbiter::tools {

/// Starts commands under the layer.
struct Launch {
  LayerFiles files;
  std::vector<Assignment> environment;
};
/// Finds the layer that the arguments name, and the environment of layerEnvironment().
[[nodiscard]] Result<Launch, LaunchError> layerLaunch(const LayerArguments &arguments);

/// Executes this process's own command line again under the layer, with --in-layer after the verb.
/// Returns only on failure, after a complaint.
[[nodiscard]] int executeInLayer(const LayerArguments &arguments, std::vector<std::string> argv);
/// True if the layer was preloaded into this process; else complains, so that what the bare host
/// draws is never taken for the layer's.
[[nodiscard]] bool isInLayer();

} // namespace arbiter::tools
