#include "interposer/process.h"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <sys/auxv.h>
#include <unistd.h>

namespace arbiter::interposer {

namespace {

constexpr const char *kGlxSelection = "__GLX_VENDOR_LIBRARY_NAME";
constexpr const char *kEglSelection = "__EGL_VENDOR_LIBRARY_FILENAMES";
/// Child processes find the selection already changed; these tell them what it was.
constexpr const char *kSavedGlx = "ARBITER_SAVED_GLX_VENDOR";
constexpr const char *kSavedEgl = "ARBITER_SAVED_EGL_VENDORS";
constexpr const char *kVendorName = "arbiter";
/// The ICD file's place beside the library, in the build tree and installed.
constexpr const char *kIcdFile = "/arbiter/10_arbiter.json";

char *g_savedGlx = nullptr;
char *g_savedEgl = nullptr;

char *copy(const char *text) { return text && *text ? strdup(text) : nullptr; }

/// The ICD file that names this library; empty if it lies nowhere near.
std::string ownIcdFile() {
  Dl_info self;
  if (!dladdr(reinterpret_cast<const void *>(&ownIcdFile), &self) || !self.dli_fname)
    return {};
  char *const real = realpath(self.dli_fname, nullptr);
  if (!real)
    return {};
  std::string path = real;
  free(real);
  path.resize(path.rfind('/'));
  path += kIcdFile;
  return access(path.c_str(), R_OK) == 0 ? path : std::string();
}

bool endsWith(const char *text, const char *end) {
  const std::size_t length = std::strlen(text), endLength = std::strlen(end);
  return length >= endLength && std::strcmp(text + length - endLength, end) == 0;
}

/// libglvnd reads both variables at its first use, which is after this constructor but for GL calls
/// made in constructors of the application's own libraries; `arbiter run` sets them from outside.
[[gnu::constructor]] void selectArbiter() {
  if (!layerAllowed())
    return;
  const char *const glx = getenv(kGlxSelection);
  if (glx && std::strcmp(glx, kVendorName) == 0) {
    g_savedGlx = copy(getenv(kSavedGlx));
  } else {
    g_savedGlx = copy(glx);
    if (g_savedGlx)
      setenv(kSavedGlx, g_savedGlx, 1);
    else
      unsetenv(kSavedGlx);
    setenv(kGlxSelection, kVendorName, 1);
  }
  const char *const egl = getenv(kEglSelection);
  if (egl && endsWith(egl, kIcdFile)) {
    g_savedEgl = copy(getenv(kSavedEgl));
    return;
  }
  g_savedEgl = copy(egl);
  const std::string icd = ownIcdFile();
  if (icd.empty())
    return;
  if (g_savedEgl)
    setenv(kSavedEgl, g_savedEgl, 1);
  else
    unsetenv(kSavedEgl);
  setenv(kEglSelection, icd.c_str(), 1);
}

} // namespace

bool layerAllowed() { return getauxval(AT_SECURE) == 0; }

const char *savedGlxVendor() { return g_savedGlx; }
const char *savedEglVendors() { return g_savedEgl; }

void fatal(const char *format, ...) {
  std::fputs("arbiter: ", stderr);
  va_list arguments;
  va_start(arguments, format);
  std::vfprintf(stderr, format, arguments);
  va_end(arguments);
  std::fputc('\n', stderr);
  std::abort();
}

} // namespace arbiter::interposer
