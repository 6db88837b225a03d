#pragma once
#include <memory>
#include <string>

#include "apps/tools/debug/draws/client.h"

namespace arbiter::tools::debug {

/// The drawing implementation: Arbiter's rasterizer, Arbiter's GLSL on the host, or the host's own
/// implementation of programs.
enum class Backend { Swrast, Host, Bare };

struct DrawWith {
  Backend backend = Backend::Swrast;
  std::string numerics;   ///< a name of fp::kNumericsNames
  std::string library;    ///< the layer; empty: found automatically
  std::string statistics; ///< a statistics file that the layer writes at the end; empty: none
};

/// Starts `arbiter debug-draws` and opens \p what in it; loads the layer except for Bare. Fails if
/// the layer or GL is missing, or if the document lacks something.
[[nodiscard]] Result<std::unique_ptr<DrawClient>, DebugError>
startDrawing(const DrawWith &with, const control::Json &what);

} // namespace arbiter::tools::debug
