#pragma once

/// What runs before every constructor of the process (ELF's DF_1_INITFIRST), in a library of its
/// own (libarbiter_first.so), as the flag is a library's and the layer's constructors need libc's.
///
/// libglvnd's libGLX reads __GLX_VENDOR_LIBRARY_NAME in its constructor, which runs before those of
/// a preloaded library, and starts the vendor that it names at once. Mesa's vendor starts once a
/// process, so the layer could then not stand in front of it.
namespace arbiter::interposer {

inline constexpr char kGlxSelection[] = "__GLX_VENDOR_LIBRARY_NAME";
inline constexpr char kVendorName[] = "arbiter";
inline constexpr char kLibrary[] = "libGLX_arbiter.so";

} // namespace arbiter::interposer

/// The vendor that __GLX_VENDOR_LIBRARY_NAME named where the layer is preloaded and its own name
/// was put there; null where nothing was replaced.
extern "C" [[nodiscard]] const char *arbiterReplacedVendor();
