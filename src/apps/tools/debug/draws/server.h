#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// Makes the drawer for an `open` request.
using OpenDrawer =
    std::function<Result<std::unique_ptr<Drawer>, DebugError>(const nlohmann::json &what)>;

/// Answers the requests of a DrawClient until it closes the socket. Requests and answers are lines
/// of JSON. An answer has "error", and "of_usage" of DebugError, or
///   {"open": ..}                                 -> {"width", "height"}
///   {"draw": text, "targets": n, "region": R}    -> {"bytes": n * 16 * pixels}, then the bytes
///   {"picture": R}                               -> {"bytes": 4 * pixels}, then the bytes
///   {"texture": unit, "target": n}               -> {"size": [width, height, depth]}
/// with R = {"x", "y", "width", "height"}.
/// \returns the process's exit code
[[nodiscard]] int serveDraws(int descriptor, const OpenDrawer &open);

} // namespace arbiter::tools::debug
