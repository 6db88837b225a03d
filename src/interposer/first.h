#pragma once

/// Runs before every constructor of the process (ELF's DF_1_INITFIRST). It is a library of its own
/// (libarbiter_first.so), as the flag applies to a whole library and the layer's constructors need
/// libc's.
///
/// libglvnd's libGLX reads __GLX_VENDOR_LIBRARY_NAME in its constructor, which runs before those of
/// a preloaded library, and starts the named vendor at once. Mesa's vendor starts only once in a
/// process, so that the layer could no longer get in front of it.
namespace arbiter::interposer {

inline constexpr char kGlxSelection[] = "__GLX_VENDOR_LIBRARY_NAME";
inline constexpr char kVendorName[] = "arbiter";
inline constexpr char kLibrary[] = "libGLX_arbiter.so";

} // namespace arbiter::interposer

/// Returns the value of __GLX_VENDOR_LIBRARY_NAME that the layer replaced by its own name; null if
/// it replaced nothing.
extern "C" [[nodiscard]] const char *arbiterReplacedVendor();
