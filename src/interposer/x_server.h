#pragma once
#include <string>

namespace arbiter::interposer {

/// Returns the vendors that the X server of $DISPLAY names (GLX_EXT_libglvnd), separated by spaces;
/// "" if there is no server, no GLX, or it names none. The query uses a connection of its own,
/// because libglvnd loads a vendor before it passes a display to it.
[[nodiscard]] std::string serverVendorNames();

} // namespace arbiter::interposer
