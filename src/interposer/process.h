#pragma once

namespace arbiter::defaults {
struct Choice;
} // namespace arbiter::defaults

/// Facts about the process that the library lives in, read in its constructor.
namespace arbiter::interposer {

/// Returns false in a set-user-id program: the vendors are then passed through unwrapped, and no
/// variable is read.
[[nodiscard]] bool layerAllowed();

/// Return the vendor and ICD selections that the layer replaced; null if there was none.
[[nodiscard]] const char *savedGlxVendor();
[[nodiscard]] const char *savedEglVendors();

/// Returns the defaults for this program. They are read at the first call, which settings() makes
/// at the first use of GL.
[[nodiscard]] const defaults::Choice &ownDefaults();

/// Ends the process with a message. This is the only way out where going on would recurse forever.
[[noreturn, gnu::format(printf, 1, 2)]] void fatal(const char *format, ...);

} // namespace arbiter::interposer
