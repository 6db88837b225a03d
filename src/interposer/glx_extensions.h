#pragma once

namespace arbiter::interposer {

/// GLX's extensions as the application sees them: the host's, less those that ARBITER_EXTENSIONS
/// hides. One that it asks for and the host lacks is said in the log.
/// \param host may be null
/// \return the same text for ever, as applications keep it
[[nodiscard]] const char *switchedExtensions(const char *host);

} // namespace arbiter::interposer
