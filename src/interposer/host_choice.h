#pragma once
#include <string>
#include <vector>

/// Chooses the host that the layer fronts. The first candidate that loads is used:
/// ARBITER_HOST_VENDOR, then the selection before the layer, then libglvnd's own choice.
namespace arbiter::interposer {

/// Returns libraries that may have __glx_Main, as names or paths for dlopen.
[[nodiscard]] std::vector<std::string> glxCandidates();

/// Returns libraries that may have __egl_Main.
[[nodiscard]] std::vector<std::string> eglCandidates();

/// Returns the "library_path" in an EGL ICD file's text, or "" if it has none.
[[nodiscard]] std::string icdLibraryPath(const std::string &json);

/// Opens a host library by name or path, without making its symbols visible to others, and returns
/// its symbol `entry`. Returns null if it cannot be loaded, lacks the symbol, or is this library
/// itself.
[[nodiscard]] void *openHostLibrary(const std::string &name, const char *entry);

/// Logs that none of the candidates loads. libglvnd then takes another vendor, without the layer.
/// \param api "GLX" or "EGL"
void sayNoneLoads(const char *api, const std::vector<std::string> &candidates);

/// Keeps libglvnd's library that contains `function` loaded until the process ends. An application
/// may close libGL and open it again. A new libGLX would then ask for its vendors again, but the
/// host vendor, which stays loaded, would remember the old one's functions.
void keepLibraryOf(void *function);

} // namespace arbiter::interposer
