#pragma once
#include <string>
#include <vector>

#include "apps/tools/commands.h"
#include "util/result.h"

/// Starts a command under the layer.
namespace arbiter::tools {

struct LaunchError {
  std::string message;
};

/// The paths of the layer's files.
struct LayerFiles {
  std::string preload;      ///< absolute path of libGLX_arbiter.so.0
  std::string preloaded;    ///< the value for LD_PRELOAD: `preload`, or a path with $LIB in it
  std::string preloads;     ///< `preload`, or a path with $LIB in it for processes of each width
  std::string osmesaFolder; ///< absolute path of the folder of the layer's libOSMesa.so.8; may be
                            ///< empty or contain $LIB
};

/// Finds the layer beside the executable in a build tree (../../interposer), or else in the
/// installation.
/// \param library an explicit path of the preload library, or empty
[[nodiscard]] Result<LayerFiles, LaunchError> findLayer(const std::string &library);

struct Assignment {
  std::string name;
  std::string value;
};

/// Returns the environment variables that start a command under the layer. Existing values of
/// LD_PRELOAD and LD_LIBRARY_PATH are kept after the layer's. Paths become absolute, because the
/// command may change its working folder. Fails if a profile does not load, if a value is not in
/// its set, or if LD_PRELOAD cannot hold a path.
[[nodiscard]] Result<std::vector<Assignment>, LaunchError>
layerEnvironment(const LayerFiles &files, const LayerArguments &arguments);

/// Sets the variables and replaces this process by the command.
/// Returns only on failure: 127 if there is no such command, 126 if it cannot be executed.
[[nodiscard]] int execute(const std::vector<Assignment> &environment,
                          const std::vector<std::string> &command);

} // namespace arbiter::tools
