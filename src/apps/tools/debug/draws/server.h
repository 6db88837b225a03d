#pragma once
#include <functional>
#include <memory>

#include "apps/tools/debug/pixel/drawer.h"
#include "control/message.h"

namespace arbiter::tools::debug {

/// Makes the drawer for the parameters of pixel.open.
using OpenDrawer =
    std::function<Result<std::unique_ptr<Drawer>, DebugError>(const control::Json &what)>;

/// Answers the requests of a DrawClient until it closes the socket. They are pixel.draw and
/// pixel.texture of the control protocol (docs/write/control.md), and
///   pixel.open {..}                   -> {width, height}
///   pixel.picture {x, y, width, height} -> {}
///   pixel.state {item, index, row}    -> {value: [4 numbers]}
/// The answer brings its pixels as memory beside it (control/attached.h), in any size.
/// \param descriptor of the connected socket, which is then closed
/// \returns the process's exit code
[[nodiscard]] int serveDraws(int descriptor, const OpenDrawer &open);

} // namespace arbiter::tools::debug
