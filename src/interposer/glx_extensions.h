#pragma once

namespace arbiter::interposer {

/// Returns GLX's extensions for the application: the host's without those that ARBITER_EXTENSIONS
/// hides. Logs an extension that the variable enables and the host lacks.
/// \param host may be null
/// \return a text that is never freed, as applications keep it
[[nodiscard]] const char *switchedExtensions(const char *host);

} // namespace arbiter::interposer
