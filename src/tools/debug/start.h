#pragma once
#include <memory>
#include <string>

#include "tools/debug/draws/client.h"

namespace arbiter::tools::debug {

/// What draws: Arbiter's rasterizer, GLSL of Arbiter's on the host, or the host's own
/// implementation of programs.
enum class Backend { Swrast, Host, Bare };

struct DrawWith {
  Backend backend = Backend::Swrast;
  std::string numerics;   ///< a name of fp::kNumericsNames
  std::string library;    ///< of the layer; empty: found
  std::string statistics; ///< a file that the layer writes at the end; or empty
};

/// Starts `arbiter debug-draws` under the layer (but for Bare) and opens \p what in it.
/// Errors: no layer, no GL, what the document lacks.
[[nodiscard]] Result<std::unique_ptr<DrawClient>, DebugError>
startDrawing(const DrawWith &with, const nlohmann::json &what);

} // namespace arbiter::tools::debug
