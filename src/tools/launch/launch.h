#pragma once
#include <string>
#include <vector>

#include "tools/commands.h"
#include "util/result.h"

/// How a command is started under the layer.
namespace arbiter::tools {

struct LaunchError {
  std::string message;
};

/// Where the layer's files are.
struct LayerFiles {
  std::string preload;      ///< absolute path of libGLX_arbiter.so.0
  std::string preloaded;    ///< what LD_PRELOAD gets: the same, or a path with $LIB in it
  std::string preloads;     ///< of processes of each width: the same, or with $LIB in it
  std::string osmesaFolder; ///< absolute path of the folder of the front libOSMesa.so.8, or empty;
                            ///< so may this
};

/// Beside the executable in a build tree (../interposer), else in the installation.
/// \param library an explicit path of the preload library, or empty
[[nodiscard]] Result<LayerFiles, LaunchError> findLayer(const std::string &library);

struct Assignment {
  std::string name;
  std::string value;
};

/// The environment variables that start a command under the layer. What LD_PRELOAD and
/// LD_LIBRARY_PATH already hold is kept behind the layer's. Paths become absolute, since the
/// command may change its folder. Errors: a profile that does not load, a value out of its set, a
/// path that LD_PRELOAD cannot hold.
[[nodiscard]] Result<std::vector<Assignment>, LaunchError>
layerEnvironment(const LayerFiles &files, const LayerArguments &arguments);

/// Sets the variables and replaces this process by the command.
/// Returns only on failure: 127 where there is no such command, 126 where it cannot be executed.
[[nodiscard]] int execute(const std::vector<Assignment> &environment,
                          const std::vector<std::string> &command);

} // namespace arbiter::tools
