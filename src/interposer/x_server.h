#pragma once
#include <string>

namespace arbiter::interposer {

/// The vendors that the X server of $DISPLAY names (GLX_EXT_libglvnd), parted by spaces; empty if
/// there is no server, no GLX, or it names none. Asked over a connection of its own, because
/// libglvnd loads a vendor before it names a display to it.
[[nodiscard]] std::string serverVendorNames();

} // namespace arbiter::interposer
