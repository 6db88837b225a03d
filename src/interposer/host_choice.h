#pragma once
#include <string>
#include <vector>

/// Which host the layer stands in front of: candidates in order of preference, the first that loads
/// is taken. ARBITER_HOST_VENDOR first, then what was selected before the layer, then libglvnd's
/// own way.
namespace arbiter::interposer {

/// Libraries that may hold __glx_Main: names or paths for dlopen.
[[nodiscard]] std::vector<std::string> glxCandidates();

/// Libraries that may hold __egl_Main.
[[nodiscard]] std::vector<std::string> eglCandidates();

/// The "library_path" of an EGL ICD file's text; empty if it has none.
[[nodiscard]] std::string icdLibraryPath(const std::string &json);

/// Opens a host library by name or path, without making its symbols visible to others, and looks up
/// `entry` in it. Null if it cannot be loaded, lacks the entry, or is this library itself.
[[nodiscard]] void *openHostLibrary(const std::string &name, const char *entry);

/// Keeps the library that `function` is of, libglvnd's, until the process ends. An application that
/// closes libGL and opens it again would else have a new libGLX, which asks for its vendors anew,
/// and a host vendor that remembers the old one's functions, as neither the host's library nor this
/// one goes. Kept, it knows both.
void keepLibraryOf(void *function);

} // namespace arbiter::interposer
