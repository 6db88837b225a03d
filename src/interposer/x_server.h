#pragma once
#include <string>

namespace arbiter::interposer {

/// Returns the vendors that the X server of $DISPLAY names (GLX_EXT_libglvnd), separated by spaces;
/// "" if there is no server, no GLX, or it names none. The query uses a connection of its own,
/// because libglvnd loads a vendor before it passes a display to it. The connection stays open
/// until closeServerQuery(): a server that resets when its last client leaves would do so now, and
/// refuse the application's connection meanwhile.
[[nodiscard]] std::string serverVendorNames();

/// Closes the connection of serverVendorNames(). Call it when the application has a connection.
void closeServerQuery();

} // namespace arbiter::interposer
