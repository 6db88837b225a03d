#pragma once

namespace arbiter::defaults {
struct Choice;
} // namespace arbiter::defaults

/// What the library knows about the process it lives in, read in its constructor.
namespace arbiter::interposer {

/// False in a set-user-id program: the vendors are then passed through unwrapped, and no variable
/// is read.
[[nodiscard]] bool layerAllowed();

/// The vendor and ICD selections as they were before the layer put itself in their place; null
/// where there was none.
[[nodiscard]] const char *savedGlxVendor();
[[nodiscard]] const char *savedEglVendors();

/// The defaults for this program: read when they are first asked for, which settings() does at the
/// first use of GL.
[[nodiscard]] const defaults::Choice &ownDefaults();

/// Ends the process with a message: the only way out where going on would recurse without end.
[[noreturn, gnu::format(printf, 1, 2)]] void fatal(const char *format, ...);

} // namespace arbiter::interposer
